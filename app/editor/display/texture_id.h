#pragma once

#include <imgui.h>

#include <cstdint>

namespace loomlight {

/// A driver's number of a texture as Dear ImGui's, and back. ImGui has it as a pointer, and since 1.91.4 as an integer:
/// only the cast of C makes either of the other.
inline ImTextureID textureId(uint32_t number) {
  return (ImTextureID) static_cast<uintptr_t>(number);
}
inline uint32_t textureNumber(ImTextureID id) {
  return static_cast<uint32_t>((uintptr_t)id);
}

}  // namespace loomlight
