#pragma once

#include <span>

#include "render/transport/light_columns.h"

namespace loomlight {

/// Adds to each sample, in the order of its lights, what colourOf() says of them, to the bit, whatever instruction set
/// the processor has. `lamps`: how brightly they shine beside what they shone with when the lights were met.
void addColours(const LightColumns& lights, const Colouring& colouring, Rgb lamps, std::span<Rgb> samples);

}  // namespace loomlight
