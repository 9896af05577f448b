#pragma once

#include <memory>

#include "core/base/units.h"
#include "render/colour/colour_cube.h"

namespace loomlight {

/// The picture as a printer would print it, instead of the picture.
struct SoftProof {
  std::shared_ptr<const ColourCube> prints;  ///< proofCube() of the printer; null: the picture as it is
  /// What cannot be printed is shown in kGamutWarning instead; of the picture as it is, what sRGB has not.
  bool warnsOfGamut = false;
  friend bool operator==(const SoftProof&, const SoftProof&) = default;
};

constexpr Rgb kGamutWarning{0.9f, 0.1f, 0.8f};  ///< sRGB; a colour that no cloth has by chance

/// Colours that sRGB has not have a channel below 0. They are marked where it is so by more than this part of the
/// largest: to cut it off is then a change of 1 to 4 CIEDE2000 for most colours.
constexpr float kBeyondSrgb = 0.05f;
/// Of linear light (shaders/display.frag computes the same).
bool isBeyondSrgb(const Rgb& linear);

/// An sRGB-encoded colour as the proof shows it (shaders/display.frag computes the same).
Rgb proofed(const Rgb& encoded, const SoftProof& proof);

}  // namespace loomlight
