#include "app/editor/display/frame_digest.h"

#include <imgui.h>

#include <string_view>

#include "app/editor/display/texture_id.h"
#include "core/base/checksum.h"
#include "core/base/hash.h"

namespace loomlight {
namespace {

uint64_t folded(uint64_t digest, const ImVec2& v) {
  return hashCombine(hashCombine(digest, v.x), v.y);
}

template <class T>
uint64_t folded(uint64_t digest, const ImVector<T>& values) {
  return hashCombine(digest, checksum({reinterpret_cast<const char*>(values.Data), sizeof(T) * values.size()}));
}

uint64_t folded(uint64_t digest, const ImDrawCmd& command) {
  digest = folded(digest, ImVec2(command.ClipRect.x, command.ClipRect.y));
  digest = folded(digest, ImVec2(command.ClipRect.z, command.ClipRect.w));
  digest = hashCombine(digest, textureNumber(command.GetTexID()));
  digest = hashCombine(hashCombine(digest, command.VtxOffset), command.IdxOffset);
  return hashCombine(digest, command.ElemCount);
}

}  // namespace

uint64_t digestOf(const ImDrawData& frame) {
  uint64_t digest = folded(folded(folded(0, frame.DisplayPos), frame.DisplaySize), frame.FramebufferScale);
  for (int i = 0; i < frame.CmdListsCount; ++i) {
    const ImDrawList& list = *frame.CmdLists[i];
    digest = folded(folded(digest, list.VtxBuffer), list.IdxBuffer);
    for (const ImDrawCmd& command : list.CmdBuffer) digest = folded(digest, command);
  }
  return digest;
}

}  // namespace loomlight
