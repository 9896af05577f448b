#include "app/bench/bench_table1.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench/bench_targets.h"
#include "app/bench/machine_facts.h"
#include "app/bench/studies/bench_cloths.h"
#include "app/bench/studies/cloth_study.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/progress.h"
#include "app/cli/view.h"
#include "core/base/stopwatch.h"
#include "core/shell/drape_mesh.h"

namespace loomlight {
namespace {

struct NamedLight {
  const char* name;
  LightKind kind;
};
constexpr std::array kLights{NamedLight{"sky", LightKind::sky}, NamedLight{"dome", LightKind::dome},
                             NamedLight{"headlight", LightKind::headlight}};
constexpr size_t kDomeLight = 1;            // among the lights
constexpr size_t kFibres = 0, kFinest = 1;  // among the variants

std::vector<Variant> variants() {
  return {{"fibres", Method::fibres, Estimator::loomlight, 8},
          {"resolution 8", Method::volume, Estimator::loomlight, 8},
          {"resolution 4", Method::volume, Estimator::loomlight, 4},
          {"resolution 2", Method::volume, Estimator::loomlight, 2},
          {"resolution 1", Method::volume, Estimator::loomlight, 1},
          {"resolution 8, report's estimator", Method::volume, Estimator::report, 8},
          {"resolution 8, no estimator", Method::volume, Estimator::none, 8}};
}

/// Table 1 of the report: level 9, 8, 7, 6 are resolutions 8, 4, 2, 1. Minutes on a Core i7 of 3.07 GHz.
struct ReportRow {
  const char* variant;
  double elements, megabytes;
  double sky_s, dome_s, headlight_s, construction_s;
};
constexpr ReportRow kReport[] = {{"fibres", 18'518'400, 10'000, 452, 523, 196, 440},
                                 {"resolution 8 (level 9)", 2'475'871, 177, 147, 401, 79, 88},
                                 {"resolution 4 (level 8)", 408'642, 30, 138, 362, 75, 54},
                                 {"resolution 2 (level 7)", 74'225, 5.6, 132, 352, 72, 45},
                                 {"resolution 1 (level 6)", 13'185, 1.1, 129, 311, 70, 36}};

/// One cloth, traced in every way in every light.
struct ClothResults {
  std::string name;
  std::vector<PreparedCloth> cloths;
  std::array<std::vector<TwoPictures>, kLights.size()> pictures;  ///< [light][variant]
  StudyErrors yardstick;  ///< between two arrangements of the fibres, under the dome, in the middle of the picture
};

/// Of each of the two pictures, per pixel. What the quick form asserts, it asserts under the dome.
int samplesOf(const NamedLight& light, bool quick) {
  if (quick) return light.kind == LightKind::dome ? 12 : 2;
  return 8;
}

Fabric posed(Fabric fabric, bool quick) {
  // The report's pieces have 18.5 million segments, and 3 million of the black and white cloth with its fewer fibres.
  constexpr double kReportSegments = 18'518'400, kQuickSegments = 60'000;
  const double segments = quick ? kQuickSegments : std::max(segmentsOf(fabric), kReportSegments);
  fabric = withSegments(std::move(fabric), segments);
  fabric.render.width = quick ? 40 : 240;
  fabric.render.height = quick ? 30 : 180;
  fabric.camera = cameraOf(ViewChoice{-90, 50, {}, {}}, fabric, makeDrape(fabric.drape));
  return fabric;
}

/// How far two cloths of the same yarns are from each other. No volume need be closer to the one than the other is.
bool addYardstick(const Fabric& fabric, const ReportBench& bench, const Task& task, ClothResults& results) {
  constexpr double kMiddle = 0.5;
  fmt::print(stderr, "loomlight: {}: another arrangement of the fibres\n", results.name);
  std::vector<PreparedCloth> other;
  auto prepared = prepare(rearranged(fabric), variants()[kFibres], bench, task);
  if (!prepared) return false;
  other.push_back(std::move(*prepared));
  Light dome = fabric.light;
  dome.kind = kLights[kDomeLight].kind;
  const auto pictures = renderInTurns(other, dome, samplesOf(kLights[kDomeLight], bench.quick), task);
  if (!pictures) return false;
  results.yardstick = errorsOf(pictures->front(), results.pictures[kDomeLight][kFibres], task.threads, kMiddle);
  return true;
}

std::optional<ClothResults> study(const BenchCloth& cloth, const ReportBench& bench, const Task& task) {
  ClothResults results{cloth.name, {}, {}, {}};
  const Fabric fabric = posed(cloth.fabric, bench.quick);
  for (const Variant& variant : variants()) {
    fmt::print(stderr, "loomlight: {}: making {}\n", cloth.name, variant.name);
    auto prepared = prepare(fabric, variant, bench, task);
    if (!prepared) return std::nullopt;
    results.cloths.push_back(std::move(*prepared));
  }
  for (size_t i = 0; i < kLights.size(); ++i) {
    fmt::print(stderr, "loomlight: {}: tracing under {} light\n", cloth.name, kLights[i].name);
    Light light = fabric.light;
    light.kind = kLights[i].kind;
    auto pictures = renderInTurns(results.cloths, light, samplesOf(kLights[i], bench.quick), task);
    if (!pictures) return std::nullopt;
    results.pictures[i] = std::move(*pictures);
  }
  if (!addYardstick(fabric, bench, task, results)) return std::nullopt;
  return results;
}

void addCosts(ReportPage& page, const ClothResults& results) {
  std::vector<std::vector<std::string>> rows;
  for (size_t v = 0; v < results.cloths.size(); ++v) {
    const PreparedCloth& cloth = results.cloths[v];
    std::vector<std::string> row{cloth.variant.name, fmt::format("{:.0f}", cloth.elements),
                                 fmt::format("{:.3f}", cloth.bytes / 1e6), fmt::format("{:.3f}", cloth.construction_s)};
    for (const auto& pictures : results.pictures) row.push_back(fmt::format("{:.2f}", pictures[v].render_s));
    rows.push_back(std::move(row));
  }
  page.table(
      results.name + "_costs",
      {"method", "segments or voxels", "MB", "construction, CPU s", "sky, CPU s", "dome, CPU s", "headlight, CPU s"},
      rows);
}

std::vector<std::string> errorRow(const std::string& method, const char* light, const StudyErrors& e) {
  return {method,
          light,
          fmt::format("{:+.2f}", e.mean_percent.r),
          fmt::format("{:+.2f}", e.mean_percent.g),
          fmt::format("{:+.2f}", e.mean_percent.b),
          fmt::format("{:.2f}", e.rms_percent),
          fmt::format("{:.4f}", e.flip)};
}

void addErrors(ReportPage& page, const ClothResults& results, int threads) {
  std::vector<std::vector<std::string>> rows;
  for (size_t v = kFinest; v < results.cloths.size(); ++v)
    for (size_t i = 0; i < kLights.size(); ++i) {
      const StudyErrors e = errorsOf(results.pictures[i][v], results.pictures[i][kFibres], threads);
      rows.push_back(errorRow(results.cloths[v].variant.name, kLights[i].name, e));
    }
  rows.push_back(errorRow("other fibres, same yarns (middle)", kLights[kDomeLight].name, results.yardstick));
  page.table(results.name + "_errors",
             {"method", "light", "red, %", "green, %", "blue, %", "RMS without noise, %", "mean FLIP"}, rows);
}

void addStrips(ReportPage& page, const ClothResults& results) {
  std::vector<Pixels8> rows;
  for (const auto& pictures : results.pictures) {
    std::vector<Pixels8> row;
    for (size_t v = kFibres; v < kFinest + 4; ++v) {
      row.push_back(shown(pictures[v]));
    }
    rows.push_back(sideBySide(row));
  }
  page.picture(results.name, stacked(rows),
               fmt::format("{}: fibres, then the volume at resolution 8, 4, 2 and 1; under sky, dome and headlight",
                           results.name));
}

/// Explicit fibres over resolution 8; 0 where nothing was measurable.
struct Ratios {
  std::string cloth;
  double memory = 0, construction = 0;
  std::array<double, kLights.size()> render{};
  double segmentsPerSecond = 0;  ///< voxelised, per core
};

double quotient(double of, double to) {
  return to > 0 ? of / to : 0;
}

Ratios ratiosOf(const ClothResults& results) {
  const PreparedCloth &fibres = results.cloths[kFibres], &finest = results.cloths[kFinest];
  Ratios ratios{"our " + results.name + " cloth",
                quotient(fibres.bytes, finest.bytes),
                quotient(fibres.construction_s, finest.construction_s),
                {},
                quotient(finest.segmentsMade, finest.construction_s)};
  for (size_t i = 0; i < kLights.size(); ++i)
    ratios.render[i] = quotient(results.pictures[i][kFibres].render_s, results.pictures[i][kFinest].render_s);
  return ratios;
}

Ratios reportsRatios() {
  const ReportRow &fibres = kReport[0], &finest = kReport[1];
  return {"the report's blue cloth",
          quotient(fibres.megabytes, finest.megabytes),
          quotient(fibres.construction_s, finest.construction_s),
          {quotient(fibres.sky_s, finest.sky_s), quotient(fibres.dome_s, finest.dome_s),
           quotient(fibres.headlight_s, finest.headlight_s)},
          quotient(fibres.elements, finest.construction_s)};
}

void addRatios(ReportPage& page, const std::vector<Ratios>& all) {
  std::vector<std::vector<std::string>> rows;
  for (const Ratios& ratios : all) {
    std::vector<std::string>& row = rows.emplace_back();
    row = {ratios.cloth, ratioText(ratios.memory), ratioText(ratios.construction)};
    for (const double render : ratios.render) row.push_back(ratioText(render));
    row.push_back(fmt::format("{:.3g} M", ratios.segmentsPerSecond / 1e6));
  }
  page.heading("Explicit fibres over resolution 8");
  page.table("table1_ratios",
             {"cloth", "memory", "construction", "sky", "dome", "headlight", "segments voxelised per s and core"},
             rows);
}

std::vector<Target> targetsOf(const Ratios& blue) {
  using Kind = Target::Kind;
  return {{"memory, explicit : resolution 8, the report's cloth", "57 : 1", "", Kind::ratio, 1000, 10000, blue.memory},
          {"construction, explicit : resolution 8", "5 : 1", "", Kind::ratio, 50, 500, blue.construction},
          {"render, explicit : resolution 8, equal samples, sky", "3.1 : 1", "", Kind::ratio, 4, 10, blue.render[0]},
          {"the same, dome", "1.3 : 1", "4.1 : 1", Kind::ratio, 4, 10, blue.render[1]},
          {"the same, headlight", "2.5 : 1", "", Kind::ratio, 4, 10, blue.render[2]},
          {"voxelising, segments per second and core", "0.2 M", "6-21 M", Kind::perSecond, 10e6, 30e6,
           blue.segmentsPerSecond}};
}

void addReport(ReportPage& page) {
  std::vector<std::vector<std::string>> rows;
  for (const ReportRow& r : kReport)
    rows.push_back({r.variant, fmt::format("{:.0f}", r.elements), fmt::format("{:g}", r.megabytes),
                    fmt::format("{:g}", r.construction_s), fmt::format("{:g}", r.sky_s), fmt::format("{:g}", r.dome_s),
                    fmt::format("{:g}", r.headlight_s)});
  page.heading("The report's Table 1, blue cloth, for comparison");
  page.table("table1_report", {"method", "lines or voxels", "MB", "construction, s", "sky, s", "dome, s", "point, s"},
             rows);
}

}  // namespace

bool benchTable1(const ReportBench& bench, const Task& task) {
  Stopwatch watch;
  ReportPage page(bench.folder, "table1", "Table 1: explicit fibres and the volume");
  page.paragraph(
      "Four cloths round a cylinder, at equal samples per pixel. Seconds are processor time of all threads, of two "
      "pictures with different seeds; the ways to trace took turns, a few samples each. Errors are against the fibres "
      "that the volume was made of: difference of the mean colour, the relative RMS of pixels free of noise "
      "(<(A - R1)(B - R2)> / <R1 R2>; below zero where noise has the last word), and FLIP, which keeps its noise. The "
      "yardstick is "
      "the last line: how far explicit fibres are from explicit fibres that lie otherwise in the same yarns, in the "
      "middle half of the picture.");
  std::vector<Ratios> all{reportsRatios()};
  for (const BenchCloth& cloth : cylinderCloths()) {
    const auto results = study(cloth, bench, task);
    if (!results) return false;
    page.heading("The " + results->name + " cloth");
    addCosts(page, *results);
    addErrors(page, *results, task.threads);
    addStrips(page, *results);
    all.push_back(ratiosOf(*results));
  }
  addRatios(page, all);
  addReport(page);
  page.paragraph(fmt::format("Measured in {} on {}", durationText(watch.lap()), machineFacts(task.threads)));
  addTargets(page, "table1_targets", targetsOf(all[1]));
  fmt::print("{}\n", page.finish());
  return true;
}

}  // namespace loomlight
