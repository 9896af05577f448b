#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "core/fabric/palette/palette.h"

namespace loomlight {

/// Six hexadecimal digits, with or without the sign: encoded sRGB, channels in [0, 1].
std::optional<glm::dvec3> hexColour(std::string_view text);

/// A colour as people type it: "#1a2b3c", or "Lab 52.1 40 -12" with its numbers apart by spaces or commas (D65, 2
/// degree observer, as on an instrument set to daylight). nullopt: neither, or beyond what a colour can be.
std::optional<NamedColour> colourFromCode(std::string_view text);

}  // namespace loomlight
