#pragma once

#include <array>
#include <span>

#include "core/base/units.h"
#include "render/optics/bcsdf.h"
#include "render/scene/colouring.h"

namespace loomlight {

/// Light that a path has met, as it would be if nothing were absorbed, and what colour hangs on beside the lengths
/// travelled: the fibre that sent a lamp's light onto the path, all modes at once. Light that the path has found by
/// itself has one mode, R, of which nothing is absorbed.
struct PathLight {
  static constexpr int kNoFibre = -1;

  Rgb radiance{0};  ///< with all weights of the path
  std::array<float, FibreBcsdf::kModes> modes{1, 0, 0, 0};
  int material = 0;               ///< of that fibre
  float traverse_mm = 0;          ///< length of one traverse of it: mode p makes p of them; 0: there is no such fibre
  float internalReflectance = 0;  ///< as FibreBcsdf::Value: the residual makes 3, 4, ... in a geometric series

  /// The material of the fibre that sent it onto the path, or kNoFibre.
  int sender() const { return traverse_mm > 0 ? material : kNoFibre; }
  /// Its radiance; times its one mode where the path has found the light by itself.
  Rgb arriving() const { return sender() == kNoFibre ? radiance * modes[0] : radiance; }
};

/// Whether a path that has travelled these lengths has been inside of any fibre.
bool isWithinFibres(std::span<const float> lengths_mm);

/// exp(-sum sigma_k L_k): what is left of light after these lengths inside the fibres of each material.
Rgb transmittance(std::span<const Rgb> absorption_per_mm, std::span<const float> lengths_mm);

/// What is left in each band of light that has gone these lengths inside the fibres of each material, 1 at first.
Spectrum leftInBands(std::span<const float> lengths_mm, const Colouring& colouring);

/// The colour that light brings to the eye along a path that has travelled these lengths; one of each per material. In
/// primaries it takes two exponentials of four numbers; where materials are known in bands, 9 or 18 more.
Rgb colourOf(const PathLight& light, std::span<const float> lengths_mm, const Colouring& colouring);

}  // namespace loomlight
