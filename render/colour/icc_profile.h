#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "render/colour/colour_cube.h"

namespace loomlight {

/// A colour profile (ICC.1, version 2 or 4) of a display or a printer. Immutable; only profiles that can be used are
/// made.
struct IccProfile {
  enum class Device { display, printer };
  Device device = Device::display;
  std::string description;  ///< as the profile calls itself; its file's name where it does not
  std::string bytes;
};

/// Throws InputError, which names the file and what is wrong: not a profile, cut short, of a camera or scanner, a link
/// of two devices, a display that is not of red, green and blue.
IccProfile readIccProfile(const std::string& file);
/// Of bytes that came from elsewhere (the window system); `from` stands for the file in messages.
IccProfile iccProfile(std::string bytes, const std::string& from);

/// What a display must be sent for sRGB colours to be seen: relative colorimetric, with black as dark as the display
/// has it (black point compensation). The fourth number is 1. Colours that the display has not are cut off.
ColourCube displayCube(const IccProfile& display);

/// sRGB colours as they come out of a printer, in sRGB again: relative colorimetric with black point compensation on
/// the way to the paper, whose white is shown as white. The fourth number is the CIEDE2000 between the colour and the
/// nearest that the inks have, as the profile says.
ColourCube proofCube(const IccProfile& printer);
/// Beyond this difference a colour is said to be out of a printer's gamut: what of tables of inks is only inexact is
/// below.
constexpr float kOutOfGamut_deltaE = 3;

}  // namespace loomlight
