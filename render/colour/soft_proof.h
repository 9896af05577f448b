#pragma once

#include <memory>

#include "core/base/units.h"
#include "render/colour/colour_cube.h"

namespace loomlight {

/// The picture as a printer would print it, instead of the picture.
struct SoftProof {
  std::shared_ptr<const ColourCube> prints;  ///< proofCube() of the printer; null: the picture as it is
  bool warnsOfGamut = false;                 ///< what cannot be printed is shown in kGamutWarning instead
  friend bool operator==(const SoftProof&, const SoftProof&) = default;
};

constexpr Rgb kGamutWarning{0.9f, 0.1f, 0.8f};  ///< sRGB; a colour that no cloth has by chance

/// An sRGB-encoded colour as the proof shows it (shaders/display.frag computes the same).
Rgb proofed(const Rgb& encoded, const SoftProof& proof);

}  // namespace loomlight
