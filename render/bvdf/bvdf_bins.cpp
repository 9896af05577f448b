#include "render/bvdf/bvdf_bins.h"

#include <algorithm>
#include <cmath>

#include "core/base/modulo.h"
#include "core/base/units.h"

namespace loomlight {
namespace {

int binOf(float angle, float range, int bins) {
  return std::clamp(static_cast<int>(angle / range * static_cast<float>(bins)), 0, bins - 1);
}

}  // namespace

glm::mat3 eventFrame(glm::vec3 normal, glm::vec3 tangent) {
  glm::vec3 x = glm::cross(normal, tangent);
  float length = glm::length(x);
  if (length < 1e-6f) {
    x = glm::cross(normal, std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
    length = glm::length(x);
  }
  x /= length;
  return {x, glm::cross(normal, x), normal};
}

BvdfAngles bvdfAngles(glm::vec3 wi, glm::vec3 wo) {
  if (wo.z < 0) {
    wi = {-wi.x, wi.y, -wi.z};
    wo = {-wo.x, wo.y, -wo.z};
  }
  BvdfAngles angles;
  angles.thetaO = std::acos(std::min(wo.z, 1.0f));
  angles.thetaI = std::acos(std::clamp(wi.z, -1.0f, 1.0f));
  angles.phiO = std::atan2(wo.y, wo.x);
  angles.phiI = std::atan2(wi.y, wi.x);
  if (angles.phiO < 0) {
    angles.phiO += kPiF;
    angles.phiI += kPiF;
  }
  if (angles.phiO >= kPiF) {  // atan2 rounds to pi
    angles.phiO -= kPiF;
    angles.phiI -= kPiF;
  }
  if (angles.phiI < 0) angles.phiI += 2 * kPiF;
  if (angles.phiI >= 2 * kPiF) angles.phiI -= 2 * kPiF;
  return angles;
}

BvdfBin BvdfBin::wrapped(BvdfBin b, const BvdfResolution& r) {
  const int half = r.phiI / 2;
  // Beyond the normal the eye's azimuth turns by pi, which by symmetry is the light's turning back by pi.
  if (b.thetaO < 0) {
    b.thetaO = -1 - b.thetaO;
    b.phiI += half;
  }
  b.thetaO = std::min(b.thetaO, r.thetaO - 1);  // nothing is known of eyes below the horizon
  if (b.phiO < 0 || b.phiO >= r.phiO) {
    b.phiO = wrap(b.phiO, r.phiO);
    b.phiI += half;
  }
  if (b.thetaI < 0 || b.thetaI >= r.thetaI) {
    b.thetaI = b.thetaI < 0 ? -1 - b.thetaI : 2 * r.thetaI - 1 - b.thetaI;
    b.phiI += half;
  }
  b.phiI = ((b.phiI % r.phiI) + r.phiI) % r.phiI;
  return b;
}

BvdfBin BvdfBin::at(const BvdfAngles& angles, const BvdfResolution& r) {
  return {binOf(angles.thetaO, kPiF / 2, r.thetaO), binOf(angles.phiO, kPiF, r.phiO),
          binOf(angles.thetaI, kPiF, r.thetaI), binOf(angles.phiI, 2 * kPiF, r.phiI)};
}

}  // namespace loomlight
