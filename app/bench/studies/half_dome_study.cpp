#include "app/bench/studies/half_dome_study.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/bench/studies/cloth_study.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/half_dome_picture.h"

namespace loomlight {
namespace {

struct DomeLight {
  const char* name;
  LightKind kind;
  double elevation_deg;
};
constexpr DomeLight kLights[] = {{"above", LightKind::directional, 90},
                                 {"45 degrees", LightKind::directional, 45},
                                 {"behind, 45 degrees", LightKind::directional, -45},
                                 {"dome", LightKind::dome, 90}};

PicturePair pairOf(const HalfDomeMeasure& measure, const HalfDomeMeasure& reference) {
  const HalfDomeGrid& grid = measure.grid;
  return {{grid.azimuths, grid.inclinations, measure.radiance},
          {grid.azimuths, grid.inclinations, reference.radiance},
          "measured",
          "reference"};
}

std::vector<std::string> errorRow(const std::string& cloth, const char* light, const TwoMeasures& volume,
                                  const TwoMeasures& fibres, int threads) {
  const double bias = squaredDifference(volume, fibres).value;
  glm::dvec3 mean(0);
  for (size_t k = 0; k < 2; ++k)
    mean += 0.5 * compare(pairOf(volume[k], fibres[k]), Viewing{}, threads).meanDifference_percent();
  return {cloth,
          light,
          fmt::format("{:+.2f}", mean.r),
          fmt::format("{:+.2f}", mean.g),
          fmt::format("{:+.2f}", mean.b),
          fmt::format("{:.2f}", 100 * std::copysign(std::sqrt(std::abs(bias)), bias))};
}

}  // namespace

std::optional<TwoMeasures> measureTwice(const Scene& scene, const Medium& medium, const Light& light,
                                        const HalfDomeGrid& grid, int samples, const Task& task) {
  TwoMeasures measures;
  for (size_t k = 0; k < 2; ++k) {
    const auto lit = relit(scene, light, scene.fabric->render.seed + k, task);
    if (!lit) return std::nullopt;
    auto measure = measureHalfDome(*lit, medium, grid, samples, task);
    if (!measure) return std::nullopt;
    measures[k] = std::move(*measure);
  }
  return measures;
}

Estimate squaredDifference(const TwoMeasures& measures, const TwoMeasures& reference) {
  return noiseFreeBiasEstimate(pairOf(measures[0], reference[0]), pairOf(measures[1], reference[1]));
}

std::optional<HalfDomeStudy> studyHalfDomes(const BenchCloth& cloth, const ReportBench& bench, const Task& task) {
  const HalfDomeGrid grid = bench.quick ? HalfDomeGrid{8, 3} : HalfDomeGrid{24, 8};
  const int samples = bench.quick ? 256 : 2048;
  const Fabric patch = halfDomePatch(cloth.fabric, grid);
  fmt::print(stderr, "loomlight: half-domes: {}\n", cloth.name);
  const auto fibres = prepare(patch, {"fibres", Method::fibres, Estimator::loomlight, 8}, bench, task);
  if (!fibres) return std::nullopt;
  const auto volume = prepare(patch, {"volume", Method::volume, Estimator::loomlight, 8}, bench, task);
  if (!volume) return std::nullopt;
  HalfDomeStudy study;
  std::vector<Pixels8> rows;
  for (const DomeLight& choice : kLights) {
    Light light;
    light.kind = choice.kind;
    light.azimuth_deg = 0;
    light.elevation_deg = choice.elevation_deg;
    const auto truth = measureTwice(*fibres->scene, *fibres->medium, light, grid, samples, task);
    if (!truth) return std::nullopt;
    const auto ours = measureTwice(*volume->scene, *volume->medium, light, grid, samples, task);
    if (!ours) return std::nullopt;
    study.rows.push_back(errorRow(cloth.name, choice.name, *ours, *truth, task.threads));
    const double unit = paperRadiance(light);
    const int side = bench.quick ? 64 : 192;
    rows.push_back(sideBySide(
        {halfDomePicture((*truth)[0], unit, Tone{}, side), halfDomePicture((*ours)[0], unit, Tone{}, side)}));
  }
  study.picture = stacked(rows);
  return study;
}

}  // namespace loomlight
