#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/widgets/ui.h"

namespace loomlight {

/// What is seen of a file before it is opened.
struct FilePreview {
  ImTextureID picture{};           ///< null where there is none, or not yet
  ImVec2 size;                     ///< of the picture, in pixels
  std::vector<std::string> lines;  ///< what it is, in a few words each
  bool isComing = false;
};

/// In the rest of the line: the picture as large as `width` allows, and the lines below it.
void drawFilePreview(Ui& ui, const FilePreview& preview, float width, float height);

}  // namespace loomlight
