#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A lamp that has a name: an illuminant of the CIE, or the black body of a temperature.
struct NamedLamp {
  StandardIlluminant illuminant = StandardIlluminant::d65;
  double temperature_K = 0;  ///< of a black body
  bool operator==(const NamedLamp&) const = default;
};

/// How lamps are written wherever people write them, and as other programs' files do: as the CIE does (D65, LED-B3), in
/// capitals or not, with "-", "_" or a blank between; "FL2" is F2, likewise of the other tubes, and "TL84" is F11;
/// "2856 K" and "2856K" are black bodies, of any temperature. Names of choices in a fabric's file are such names too,
/// in small letters. nullopt where it is none; the lamp of a file has no name.
std::optional<NamedLamp> lampFromName(std::string_view name);

/// As the CIE writes it: "D65", "LED-B3"; "2856 K". Of a lamp that has a name.
std::string lampName(const NamedLamp& lamp);
/// All but those of black bodies.
std::vector<std::string> lampNames();

}  // namespace loomlight
