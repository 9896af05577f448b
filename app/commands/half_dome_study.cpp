#include "app/commands/half_dome_study.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/commands/cloth_study.h"
#include "app/commands/half_dome_picture.h"
#include "app/commands/report_page.h"
#include "render/metrics/comparison.h"
#include "render/trace/half_dome.h"

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

using TwoMeasures = std::array<HalfDomeMeasure, 2>;

/// The same measurement with two patterns of noise.
std::optional<TwoMeasures> measureTwice(const PreparedCloth& cloth, const Light& light, const HalfDomeGrid& grid,
                                        int samples, const Task& task) {
  TwoMeasures measures;
  for (size_t k = 0; k < 2; ++k) {
    Fabric fabric = *cloth.scene->fabric;
    fabric.light = light;
    fabric.render.seed += k;
    const auto scene = makeScene(std::make_shared<const Fabric>(std::move(fabric)), task, cloth.scene.get());
    if (!scene) return std::nullopt;
    auto measure = measureHalfDome(*scene, *cloth.medium, grid, samples, task);
    if (!measure) return std::nullopt;
    measures[k] = std::move(*measure);
  }
  return measures;
}

PicturePair pairOf(const HalfDomeMeasure& volume, const HalfDomeMeasure& fibres) {
  const HalfDomeGrid& grid = volume.grid;
  return {{grid.azimuths, grid.inclinations, volume.radiance},
          {grid.azimuths, grid.inclinations, fibres.radiance},
          "volume",
          "fibres"};
}

std::vector<std::string> errorRow(const std::string& cloth, const char* light, const TwoMeasures& volume,
                                  const TwoMeasures& fibres, int threads) {
  const PicturePair first = pairOf(volume[0], fibres[0]), second = pairOf(volume[1], fibres[1]);
  const double bias = noiseFreeBias(first, second);
  const glm::dvec3 mean = 0.5 * (compare(first, Viewing{}, threads).meanDifference_percent() +
                                 compare(second, Viewing{}, threads).meanDifference_percent());
  return {cloth,
          light,
          fmt::format("{:+.2f}", mean.r),
          fmt::format("{:+.2f}", mean.g),
          fmt::format("{:+.2f}", mean.b),
          fmt::format("{:.2f}", 100 * std::copysign(std::sqrt(std::abs(bias)), bias))};
}

}  // namespace

std::optional<HalfDomeStudy> studyHalfDomes(const BenchCloth& cloth, const ReportBench& bench, const Task& task) {
  const HalfDomeGrid grid = bench.quick ? HalfDomeGrid{8, 3} : HalfDomeGrid{48, 12};
  const int samples = bench.quick ? 512 : 4096;
  const Fabric patch = halfDomePatch(cloth.fabric, grid);
  fmt::print(stderr, "loomlight: half-domes: {}\n", cloth.name);
  const auto fibres =
      prepare(patch, {"fibres", Method::fibres, Estimator::loomlight, 8}, bench.memoryLimit_bytes, task);
  if (!fibres) return std::nullopt;
  const auto volume =
      prepare(patch, {"volume", Method::volume, Estimator::loomlight, 8}, bench.memoryLimit_bytes, task);
  if (!volume) return std::nullopt;
  HalfDomeStudy study;
  std::vector<Pixels8> rows;
  for (const DomeLight& choice : kLights) {
    Light light;
    light.kind = choice.kind;
    light.azimuth_deg = 0;
    light.elevation_deg = choice.elevation_deg;
    const auto truth = measureTwice(*fibres, light, grid, samples, task);
    if (!truth) return std::nullopt;
    const auto ours = measureTwice(*volume, light, grid, samples, task);
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
