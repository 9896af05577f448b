#pragma once

#include <string_view>

#include "core/base/units.h"

namespace loomlight {

/// What a dyer would call a colour, among some forty names: "navy", "rust", "ecru". Linear reflectance.
std::string_view colourName(const Rgb& linear);

}  // namespace loomlight
