#pragma once

#include <glm/glm.hpp>

namespace loomlight {

/// Linear-light colour or per-channel coefficient; Rec. 709 primaries, D65 white.
using Rgb = glm::vec3;

/// Which set of yarns: the warp (ends, along y) or the weft (picks, along x).
enum class System { warp = 0, weft = 1 };
/// The set of yarns that those of `system` cross.
constexpr System crossSystem(System system) {
  return system == System::warp ? System::weft : System::warp;
}

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr auto kPiF = static_cast<float>(kPi);
inline constexpr double kMmPerUm = 1e-3;
inline constexpr double kMmPerInch = 25.4;

}  // namespace loomlight
