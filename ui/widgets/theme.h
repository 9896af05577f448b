#pragma once

#include <imgui.h>

namespace loomlight {

/// The colours of the interface. Neutral throughout, because the designer's cloth is judged beside them: the accent
/// marks what is selected, `warning` what needs attention, and nothing else has a hue.
struct Theme {
  ImVec4 window;  ///< behind the panels, and the splitters between them
  ImVec4 panel;
  ImVec4 field;  ///< where values are edited
  ImVec4 fieldHover;
  ImVec4 fieldFill;  ///< how far a value is along its range
  ImVec4 line;
  ImVec4 text;
  ImVec4 textQuiet;  ///< labels, units, hints
  ImVec4 accent;
  ImVec4 onAccent;  ///< text upon the accent
  ImVec4 warning;
  ImVec4 error;
  ImVec4 popup;
  ImVec4 paper;     ///< point paper: weft over
  ImVec4 ink;       ///< point paper: warp over
  ImVec4 surround;  ///< of the viewport: 18 % reflectance, in sRGB

  static Theme dark();
  static Theme light();

  /// Sets colours and measures of ImGui, for a screen of this scale.
  void apply(ImGuiStyle& style, float scale) const;
};

/// `colour` with another opacity, packed for draw lists.
inline ImU32 packed(const ImVec4& colour, float opacity = 1.0f) {
  return ImGui::ColorConvertFloat4ToU32(ImVec4(colour.x, colour.y, colour.z, colour.w * opacity));
}

}  // namespace loomlight
