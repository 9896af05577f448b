#pragma once

#include <glm/glm.hpp>

#include "core/base/units.h"

namespace loomlight {

/// CIE XYZ of D65 white, Y = 1, as the matrix of Rec. 709 has it.
glm::dvec3 d65Xyz();

/// CIE XYZ over that of the white point: (1, 1, 1) is D65 white. From linear Rec. 709 light, primaries and white of
/// ITU-R BT.709; greys have three equal components.
glm::dvec3 whiteXyzFromLinear(const glm::dvec3& linear);
glm::dvec3 linearFromWhiteXyz(const glm::dvec3& xyz);

/// CIELAB 1976 (CIE 15:2004): L* in [0, 100] for light in [0, 1].
struct Lab {
  double L = 0, a = 0, b = 0;
};
Lab labFromWhiteXyz(const glm::dvec3& xyz);
glm::dvec3 whiteXyzFromLab(const Lab& lab);

inline Lab labFromLinear(const glm::dvec3& linear) {
  return labFromWhiteXyz(whiteXyzFromLinear(linear));
}
inline glm::dvec3 linearFromLab(const Lab& lab) {
  return linearFromWhiteXyz(whiteXyzFromLab(lab));
}

/// CIEDE2000 with kC = kH = 1, as Sharma, Wu and Dalal 2005 make its hues unambiguous. 1 is about the smallest
/// difference an eye sees between two patches side by side. `kL`: how much more of lightness is let pass; the textile
/// trade takes 2.
double ciede2000(const Lab& one, const Lab& other, double kL = 1);

}  // namespace loomlight
