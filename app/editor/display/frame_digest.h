#pragma once

#include <cstdint>

struct ImDrawData;

namespace loomlight {

/// What makes a frame of Dear ImGui look as it does, in 64 bits: frames of equal digests look alike, as long as the
/// pictures that they show do. Costs a reading of all vertices.
uint64_t digestOf(const ImDrawData& frame);

}  // namespace loomlight
