#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// How large a label on the picture is. `room`: beyond that width its text is broken into lines; 0: it is not.
ImVec2 pillSize(Ui& ui, const std::string& text, float room = 0);
/// A label on the picture that reads on any cloth.
void pill(Ui& ui, ImVec2 corner, const std::string& text, const ImVec4& colour, float room = 0);

}  // namespace loomlight
