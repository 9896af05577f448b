#pragma once

#include <imgui.h>

namespace loomlight {

/// The type of the interface: one family, two weights. Digits have one width, so a number that changes does not dance.
struct Fonts {
  ImFont* regular = nullptr;  ///< 14 px at scale 1
  ImFont* strong = nullptr;   ///< headings
  ImFont* small = nullptr;    ///< 12 px: captions
};

/// Replaces what the atlas holds. The fonts travel inside the program. Call before the atlas is uploaded.
Fonts loadFonts(ImFontAtlas& atlas, float scale);

}  // namespace loomlight
