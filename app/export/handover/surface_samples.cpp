#include "app/export/handover/surface_samples.h"

#include <algorithm>
#include <cmath>

#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

/// Square root of the roughness of a yarn's fibres; of a blend the mean.
double rootOfRoughness(const Yarn& yarn, const std::vector<Fibre>& fibres) {
  const auto rootOf = [&](int fibre) { return std::sqrt(fibres[static_cast<size_t>(fibre)].longitudinalRoughness); };
  if (!yarn.blendFibre) return rootOf(yarn.fibre);
  return std::lerp(rootOf(yarn.fibre), rootOf(*yarn.blendFibre), blendNumberShare(yarn, fibres));
}

}  // namespace

std::vector<float> roughnessScales(const SideMaps& side, const Fabric& fabric) {
  std::vector<float> roots;
  for (const Yarn& yarn : fabric.yarns) roots.push_back(static_cast<float>(rootOfRoughness(yarn, fabric.fibres)));
  double sum = 0, weight = 0;
  for (size_t i = 0; i < side.tile.yarn.size(); ++i) {
    if (side.tile.yarn[i] < 0) continue;
    sum += side.tile.opacity[i] * roots[static_cast<size_t>(side.tile.yarn[i])];
    weight += side.tile.opacity[i];
  }
  for (float& root : roots) root = sum > 0 ? static_cast<float>(root * weight / sum) : 1.0f;
  return roots;
}

PrincipledPoint surfacePoint(const SideMaps& side, const std::vector<float>& scales, size_t pixel) {
  PrincipledPoint at;
  at.normal = side.tile.normal[pixel];
  const glm::vec2 along = side.along[pixel];
  at.anisotropyScale = std::min(1.0f, glm::length(along));
  if (at.anisotropyScale > 0) at.drawnOut = glm::normalize(glm::vec2(-along.y, along.x));
  if (side.tile.yarn[pixel] >= 0) at.roughnessScale = scales[static_cast<size_t>(side.tile.yarn[pixel])];
  at.reflected = side.reflected[pixel];
  at.transmitted = side.transmitted[pixel];
  return at;
}

MeanColours meanColours(const SideMaps& side) {
  glm::dvec3 reflected(0), transmitted(0);
  for (size_t i = 0; i < side.reflected.size(); ++i) {
    reflected += side.tile.opacity[i] * side.reflected[i];
    transmitted += side.tile.opacity[i] * side.transmitted[i];
  }
  const auto count = static_cast<double>(side.reflected.size());
  return {Rgb(reflected / count), Rgb(transmitted / count)};
}

std::vector<SurfaceSample> surfaceSamples(const SideMaps& side, const Fabric& fabric, int count) {
  const std::vector<float> scales = roughnessScales(side, fabric);
  const size_t width = static_cast<size_t>(side.tile.width), height = static_cast<size_t>(side.tile.height);
  std::vector<SurfaceSample> samples;
  MeanColours mean;
  // A lattice of rank 1 with the golden ratio: even in both directions, and in no step with the threads. Every other
  // point is the mirror image of the one before, so that the cloth turned over is seen at the same points.
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < count; ++i) {
    const int pair = i / 2;
    const double across = (2 * pair + 0.5) / count, u = i % 2 == 0 ? across : 1 - across;
    const double v = std::fmod(0.5 + pair * kGolden, 1.0);
    const size_t pixel = static_cast<size_t>(v * static_cast<double>(height)) * width +
                         static_cast<size_t>(u * static_cast<double>(width));
    const float opacity = side.tile.opacity[pixel];
    samples.push_back({surfacePoint(side, scales, pixel), opacity});
    mean.reflected += opacity * side.reflected[pixel] / static_cast<float>(count);
    mean.transmitted += opacity * side.transmitted[pixel] / static_cast<float>(count);
  }
  const MeanColours wanted = meanColours(side);
  const Rgb reflected = quotient(wanted.reflected, mean.reflected);
  const Rgb transmitted = quotient(wanted.transmitted, mean.transmitted);
  for (SurfaceSample& sample : samples) {
    sample.point.reflected *= reflected;
    sample.point.transmitted *= transmitted;
  }
  return samples;
}

}  // namespace loomlight
