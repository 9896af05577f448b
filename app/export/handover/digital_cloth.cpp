#include "app/export/handover/digital_cloth.h"

#include "app/export/handover/measured_surface.h"
#include "app/export/handover/surface_samples.h"
#include "app/export/task_part.h"

namespace loomlight {
namespace {

constexpr double kBytesPerPixel = 400;  ///< of both sides' maps, a film, and what is written of them, at most

/// `seen`: scaled to the maps.
void fit(DigitalSide& side, const MeasuredSide& seen, const Fabric& fabric, const DigitalClothOrder& order,
         int threads) {
  const std::vector<SurfaceSample> samples = surfaceSamples(side.maps, fabric, order.fitSamples);
  side.fit = fitSurface(samples, seen.reflected, seen.transmitted, threads);
  side.roughnessScales = roughnessScales(side.maps, fabric);
}

}  // namespace

std::optional<DigitalCloth> makeDigitalCloth(const Fabric& fabric, const DigitalClothOrder& order, double limit_bytes,
                                             const Task& task) {
  constexpr double kMade = 0.01, kTraced = 0.8, kMeasured = 0.95;  // of the progress
  DigitalCloth cloth;
  cloth.fabric = fabric;
  cloth.extent = tileExtent(fabric, order.joinTwist);
  const int side = order.longestSide > 0 ? order.longestSide : usualTileSide(fabric, cloth.extent);
  expectMemoryFor(fabric, cloth.extent, side, kBytesPerPixel, limit_bytes);
  cloth.measures = measuresOf(fabric, cloth.extent, partOf(task, 0, kMade));
  auto sides = tileSides(fabric, cloth.extent, side, limit_bytes, partOf(task, kMade, kTraced));
  if (!sides) return std::nullopt;
  auto measured = measuredSurface(fabric, order.measuringSamples, limit_bytes, partOf(task, kTraced, kMeasured));
  if (!measured) return std::nullopt;
  cloth.front.maps = std::move(sides->front);
  cloth.back.maps = std::move(sides->back);
  const MeanColours front = meanColours(cloth.front.maps), back = meanColours(cloth.back.maps);
  cloth.front.tileOverMeasured = quotient(front.reflected, albedoAlongNormal(measured->front.reflected));
  cloth.back.tileOverMeasured = quotient(back.reflected, albedoAlongNormal(measured->back.reflected));
  scaleToMaps(front, back, *measured);
  fit(cloth.front, measured->front, fabric, order, task.threads);
  if (task.stopped()) return std::nullopt;
  fit(cloth.back, measured->back, fabric, order, task.threads);
  if (task.stopped()) return std::nullopt;
  task.report(1);
  return cloth;
}

}  // namespace loomlight
