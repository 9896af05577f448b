#include "app/export/handover/digital_cloth.h"

#include "app/export/handover/measured_surface.h"
#include "app/export/handover/surface_samples.h"
#include "app/export/task_part.h"

namespace loomlight {
namespace {

DigitalSide fitted(SideMaps maps, MeasuredSide seen, const Fabric& fabric, const DigitalClothOrder& order,
                   int threads) {
  DigitalSide side;
  const MeanColours mean = meanColours(maps);
  const Rgb measured = albedoAlongNormal(seen.reflected);
  for (int c = 0; c < 3; ++c)
    if (measured[c] > 0) side.tileOverMeasured[c] = mean.reflected[c] / measured[c];
  scaleTo(mean.reflected, seen.reflected);
  scaleTo(mean.transmitted, seen.transmitted);
  const std::vector<SurfaceSample> samples = surfaceSamples(maps, fabric, order.fitSamples);
  side.fit = fitSurface(samples, seen.reflected, seen.transmitted, threads);
  side.roughnessScales = roughnessScales(maps, fabric);
  side.maps = std::move(maps);
  return side;
}

}  // namespace

std::optional<DigitalCloth> makeDigitalCloth(const Fabric& fabric, const DigitalClothOrder& order, double limit_bytes,
                                             const Task& task) {
  constexpr double kTraced = 0.8, kMeasured = 0.95;  // of the progress
  DigitalCloth cloth;
  cloth.fabric = fabric;
  cloth.extent = tileExtent(fabric, order.joinTwist);
  const int side = order.longestSide > 0 ? order.longestSide : usualTileSide(fabric, cloth.extent);
  auto sides = tileSides(fabric, cloth.extent, side, limit_bytes, partOf(task, 0, kTraced));
  if (!sides) return std::nullopt;
  auto measured = measuredSurface(fabric, order.measuringSamples, limit_bytes, partOf(task, kTraced, kMeasured));
  if (!measured) return std::nullopt;
  cloth.measures = sides->measures;
  cloth.front = fitted(std::move(sides->front), std::move(measured->front), fabric, order, task.threads);
  if (task.stopped()) return std::nullopt;
  cloth.back = fitted(std::move(sides->back), std::move(measured->back), fabric, order, task.threads);
  if (task.stopped()) return std::nullopt;
  task.report(1);
  return cloth;
}

}  // namespace loomlight
