#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// How large a label on the picture is.
ImVec2 pillSize(Ui& ui, const std::string& text);
/// A label on the picture that reads on any cloth.
void pill(Ui& ui, ImVec2 corner, const std::string& text, const ImVec4& colour);

}  // namespace loomlight
