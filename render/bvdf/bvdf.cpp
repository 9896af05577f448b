#include "render/bvdf/bvdf.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/units.h"

namespace loomlight {
namespace {

/// The two bins whose centres enclose an angle, the first one's number, and the share of the second.
struct Between {
  int first;
  float share;
  Between(float angle, float range, int bins) {
    const float x = angle / range * static_cast<float>(bins) - 0.5f;
    const float floor = std::floor(x);
    first = static_cast<int>(floor);
    share = x - floor;
  }
};

}  // namespace

Bvdf::Bvdf(BvdfResolution resolution, HotSpot hotSpot, std::vector<float> ratios)
    : resolution_(resolution), hotSpot_(hotSpot), ratios_(std::move(ratios)) {
  assert(ratios_.size() == resolution_.bins() && resolution_.phiI % 2 == 0);
}

float Bvdf::occlusion(glm::vec3 wi, glm::vec3 wo) const {
  const BvdfAngles angles = bvdfAngles(wi, wo);
  const Between thetaO(angles.thetaO, kPiF / 2, resolution_.thetaO), phiO(angles.phiO, kPiF, resolution_.phiO),
      thetaI(angles.thetaI, kPiF, resolution_.thetaI), phiI(angles.phiI, 2 * kPiF, resolution_.phiI);
  float ratio = 0;
  for (int corner = 0; corner < 16; ++corner) {
    float weight = 1;
    const auto along = [&weight, corner](const Between& between, int axis) {
      const int upper = corner >> axis & 1;
      weight *= upper ? between.share : 1 - between.share;
      return between.first + upper;
    };
    const BvdfBin bin{along(thetaO, 0), along(phiO, 1), along(thetaI, 2), along(phiI, 3)};
    ratio += weight * ratios_[BvdfBin::wrapped(bin, resolution_).index(resolution_)];
  }
  return std::clamp(ratio * hotSpot_.occlusion(wi, wo), 0.0f, 1.0f);
}

}  // namespace loomlight
