#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace loomlight {

/// Bins of a BVDF. Eye directions lie on the cloth's near side, theta_o in [0, pi/2], and by symmetry in half the
/// azimuths, phi_o in [0, pi); directions of light are free, theta_i in [0, pi], phi_i in [0, 2 pi). All are uniform in
/// angle.
struct BvdfResolution {
  int thetaO = 8, phiO = 8, thetaI = 16, phiI = 32;  ///< phiI is even
  bool operator==(const BvdfResolution&) const = default;

  size_t bins() const { return static_cast<size_t>(thetaO) * phiO * thetaI * phiI; }
  /// The report's 32 x 64^3.
  static BvdfResolution report() { return {32, 64, 64, 64}; }
};

/// A pair of directions at an event, in the event's frame (eventFrame()), after the symmetries.
struct BvdfAngles {
  float thetaO, phiO, thetaI, phiI;  ///< in the ranges of BvdfResolution
};

/// The frame of an event: x = n x t, z = n, where n is the normal of the cloth's face and t the fibre's tangent,
/// projected into the cloth (section 8.2 of the report). Columns are the axes. Any azimuth where t is the normal.
glm::mat3 eventFrame(glm::vec3 normal, glm::vec3 tangent);

/// The unit direction at theta from the z axis, and phi about it from the x axis.
inline glm::vec3 polarDirection(float theta, float phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Angles of a pair of unit directions in the event's frame. Two rotations that map a yarn onto itself are divided out:
/// t and -t are the same fibre, so both azimuths may turn by pi; and an eye behind the cloth sees what the same yarn,
/// turned about its axis, would show to an eye before it.
BvdfAngles bvdfAngles(glm::vec3 wi, glm::vec3 wo);

/// A bin by its four coordinates. Neighbours are taken across the azimuth's seam and across the poles.
struct BvdfBin {
  int thetaO, phiO, thetaI, phiI;

  /// The bin of coordinates that may lie up to one table's size outside their ranges.
  static BvdfBin wrapped(BvdfBin bin, const BvdfResolution& resolution);
  size_t index(const BvdfResolution& r) const {
    return ((static_cast<size_t>(thetaO) * r.phiO + phiO) * r.thetaI + thetaI) * r.phiI + phiI;
  }
  static BvdfBin at(const BvdfAngles& angles, const BvdfResolution& resolution);
};

}  // namespace loomlight
