#include "app/bench/bench_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench/machine_facts.h"
#include "app/bench/studies/bench_cloths.h"
#include "app/bench/studies/cloth_study.h"
#include "app/bench/studies/density_study.h"
#include "app/bench/studies/half_dome_study.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/progress.h"
#include "app/cli/view.h"
#include "core/base/stopwatch.h"
#include "core/fabric/model/choice_names.h"
#include "core/shell/drape_mesh.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/bvdf/bvdf_picture.h"
#include "render/colour/tone.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

std::string percent(double value) {
  return fmt::format("{:+.2f}", value);
}

/// Fig. 1: pieces that nobody could trace fibre by fibre.
bool addLargePieces(ReportPage& page, const ReportBench& bench, const Task& task) {
  page.heading("Fig. 1: a carpet, a blanket, a curtain");
  std::vector<std::vector<std::string>> rows;
  std::vector<Pixels8> pictures;
  for (BenchCloth& cloth : largeCloths()) {
    fmt::print(stderr, "loomlight: Fig. 1: {}\n", cloth.name);
    RenderSettings& settings = cloth.fabric.render;
    settings.samplesPerPixel = 8;
    if (bench.quick) {
      settings.width = 64;
      settings.height = 32;
      settings.samplesPerPixel = 4;
      for (Fibre& fibre : cloth.fabric.fibres) fibre.radius_um *= 2;  // a quarter of them, soon parted
    }
    cloth.fabric.camera =
        cameraOf(ViewChoice{cloth.fabric.camera.azimuth_deg, cloth.fabric.camera.elevation_deg, {}, {}}, cloth.fabric,
                 makeDrape(cloth.fabric.drape));
    auto prepared =
        prepare(cloth.fabric, {"volume", Method::volume, settings.estimator, settings.resolution}, bench, task);
    if (!prepared) return false;
    const Scene& scene = *prepared->scene;
    Film film(settings.width, settings.height);
    CpuStopwatch watch;
    const auto samples = static_cast<uint32_t>(settings.samplesPerPixel);
    const CameraRays camera(cloth.fabric.camera, settings.width, settings.height);
    if (!renderUpTo(samples, scene, *prepared->medium, camera, film, task).complete) return false;
    rows.push_back({cloth.name, fmt::format("{:.3g}", scene.cloth->volume->counts().segmentsRepresented),
                    fmt::format("{:.3f}", prepared->bytes / 1e6), fmt::format("{:.3f}", prepared->construction_s),
                    fmt::format("{} x {} x {}", settings.width, settings.height, samples),
                    fmt::format("{:.1f}", watch.lap())});
    pictures.push_back(toPixels(film, Tone{}));
  }
  page.table("fig1",
             {"piece", "fibre segments it stands for", "MB of volume", "construction, CPU s", "pixels x samples",
              "render, CPU s"},
             rows);
  page.picture("fig1", stacked(pictures), "Carpet, blanket, curtain");
  page.paragraph("The report's pieces stand for more than 1e10 line primitives and fit into 4 GB.");
  return true;
}

/// Fig. 4: length of fibre in a voxel, against counting fibres.
bool addDensity(ReportPage& page, const Task& task) {
  page.heading("Fig. 4: density by length and by counting fibres");
  constexpr int kResolution = 8;
  const BenchCloth cloth = cylinderCloths().front();
  const auto study = studyDensity(cloth.fabric, kResolution, task);
  if (!study) return false;
  std::vector<std::vector<std::string>> rows, line;
  for (const DensityError& e : study->errors)
    rows.push_back({e.method, percent(e.length_percent), fmt::format("{:.3f}", e.voxel_percent),
                    fmt::format("{:.1f}", e.fine_percent), fmt::format("{:.1f}", e.astray_percent)});
  for (const DensityStudy::Sample& p : study->line)
    line.push_back({fmt::format("{:.2f}", p.x_um), fmt::format("{:.0f}", p.exact), fmt::format("{:.0f}", p.ours),
                    fmt::format("{:.0f}", p.counted)});
  page.table("fig4",
             {"density from", "total length, %", "RMS in voxels, %", "RMS at a quarter of a voxel, %", "astray, %"},
             rows);
  page.csv("fig4_line", {"x_um", "exact_per_mm2", "length_per_mm2", "counted_per_mm2"}, line);
  page.picture(
      "fig4", study->section,
      "A section through a warp yarn of the blue cloth: exact at a quarter of a voxel, length per voxel, fibres "
      "counted in the sphere about the voxel");
  page.paragraph(
      "Length of fibre per volume in one crossing at resolution 8, against the fibres themselves, cut at every plane "
      "of the grid. Counting is that of Moon et al. (2008) as the report tells it: n fibres that cut a sphere of "
      "radius R "
      "stand for n / (pi R^2), since the mean chord of a sphere is 4 R / 3 (Eq. 4). Errors are relative to the RMS "
      "density; at a quarter of a voxel, that of the length is all due to the voxel's size, and no number that a voxel "
      "could hold has less. Astray is what lies in voxels without fibres. fig4_line.csv goes along a line through the "
      "yarn.");
  return true;
}

/// Fig. 7: what local visibility does.
bool addLocalVisibility(ReportPage& page, const ReportBench& bench, const Task& task) {
  page.heading("Fig. 7: direct light in the volume");
  BenchCloth cloth = cylinderCloths().front();
  // Fewer make yarns of a dozen fibres, of which no statistics say what shades what.
  Fabric fabric = withSegments(cloth.fabric, bench.quick ? 300'000 : 20e6);
  fabric.render.width = bench.quick ? 32 : 160;
  fabric.render.height = bench.quick ? 24 : 120;
  fabric.camera = cameraOf(ViewChoice{-90, 50, {}, {}}, fabric, makeDrape(fabric.drape));
  std::vector<PreparedCloth> cloths;
  for (const Variant& variant : {Variant{"fibres", Method::fibres, Estimator::loomlight, 4},
                                 Variant{"volume only", Method::volume, Estimator::none, 4},
                                 Variant{"report", Method::volume, Estimator::report, 4},
                                 Variant{"loomlight", Method::volume, Estimator::loomlight, 4}}) {
    fmt::print(stderr, "loomlight: Fig. 7: {}\n", variant.name);
    auto prepared = prepare(fabric, variant, bench, task);
    if (!prepared) return false;
    cloths.push_back(std::move(*prepared));
  }
  std::vector<std::vector<std::string>> rows;
  std::vector<Pixels8> strips;
  for (const LightKind kind : {LightKind::headlight, LightKind::dome}) {
    Light light = fabric.light;
    light.kind = kind;
    const auto pictures = renderInTurns(cloths, light, bench.quick && kind != LightKind::headlight ? 8 : 32, task);
    if (!pictures) return false;
    std::vector<Pixels8> strip{shown((*pictures)[0])};
    for (size_t i = 1; i < cloths.size(); ++i) {
      const StudyErrors e = errorsOf((*pictures)[i], (*pictures)[0], task.threads);
      rows.push_back({cloths[i].variant.name, choiceName(kind), percent(e.mean_percent.r), percent(e.mean_percent.g),
                      percent(e.mean_percent.b), fmt::format("{:.2f}", e.rms_percent), fmt::format("{:.4f}", e.flip)});
      strip.push_back(shown((*pictures)[i]));
    }
    strips.push_back(sideBySide(strip));
  }
  page.table("fig7", {"estimator", "light", "red, %", "green, %", "blue, %", "RMS without noise, %", "mean FLIP"},
             rows);
  page.picture("fig7", stacked(strips),
               "The blue cloth: fibres, volume only, the report's estimator, ours; at resolution 4 (the report's level "
               "8), under headlight and dome");
  return true;
}

/// Fig. 8: the BVDF of each cloth.
bool addBvdf(ReportPage& page, const ReportBench& bench, const Task& task) {
  page.heading("Fig. 8: the BVDF");
  std::vector<Pixels8> pictures;
  for (const BenchCloth& cloth : cylinderCloths()) {
    fmt::print(stderr, "loomlight: Fig. 8: {}\n", cloth.name);
    BvdfOptions options;
    if (bench.quick) options.rays = 100'000;
    const auto set = bakeBvdf(cloth.fabric, options, BvdfCache({}), task);
    if (!set) return false;
    pictures.push_back(bvdfPicture(*set));
  }
  page.picture("fig8", stacked(pictures),
               "Blue, colourful, black and white, green; phi_o = 0, eight phi_i from 0 to 180 degrees; in each square "
               "theta_o downwards, theta_i to the right. White: no shadow");
  return true;
}

/// Figs. 11 to 15: half-domes of four cloths under two lights.
bool addHalfDomes(ReportPage& page, const ReportBench& bench, const Task& task) {
  page.heading("Figs. 11 to 15: half-dome BRDFs");
  std::vector<std::vector<std::string>> rows;
  for (const BenchCloth& cloth : cylinderCloths()) {
    // A patch of the others has ten million segments.
    if (bench.quick && cloth.name != "black_and_white") continue;
    const auto study = studyHalfDomes(cloth, bench, task);
    if (!study) return false;
    for (const auto& row : study->rows) rows.push_back(row);
    page.picture("fig11-14_" + cloth.name, study->picture,
                 fmt::format("{}: for parallel light from above, at 45 degrees, from behind, and for the dome: fibres, "
                             "volume",
                             cloth.name));
  }
  page.table("fig11-14", {"cloth", "light", "red, %", "green, %", "blue, %", "RMS without noise, %"}, rows);
  page.paragraph(
      "Each camera of the half-dome is one colour: the mean of its picture, at the place of its direction seen from "
      "above, the normal in the middle. Errors are of the volume at resolution 8 against the fibres, over all "
      "cameras.");
  return true;
}

}  // namespace

bool benchFigures(const ReportBench& bench, const Task& task) {
  Stopwatch watch;
  ReportPage page(bench.folder, "figures", "The report's figures");
  page.paragraph("Figs. 9 and 10 are the pictures of Table 1 (`loomlight bench table1`).");
  const bool complete = addLargePieces(page, bench, task) && addDensity(page, task) &&
                        addLocalVisibility(page, bench, task) && addBvdf(page, bench, task) &&
                        addHalfDomes(page, bench, task);
  if (!complete) return false;
  page.paragraph(fmt::format("Measured in {} on {}", durationText(watch.lap()), machineFacts(task.threads)));
  fmt::print("{}\n", page.finish());
  return true;
}

}  // namespace loomlight
