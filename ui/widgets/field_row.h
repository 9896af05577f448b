#pragma once

#include "ui/widgets/fields.h"

namespace loomlight {

/// The grid that all rows share: one height, labels in the left part.
inline constexpr float kLabelShare = 0.475f;

struct FieldRow {
  float width = 0;  ///< of the field
  float height = 0;
  std::string cut;  ///< the label, where its column has not the room for it
};

/// Draws the label and puts the cursor where the field begins.
FieldRow beginRow(Ui& ui, const RowText& text);
/// The panel or dialog that is drawn into: Tab does not leave it.
ImGuiID panelOfFields();
/// Tells the tests where a text does not fit its place, and nobody can read it.
void tellIfClipped(Ui& ui, const std::string& id, const char* text, float room);
/// As much of a text as fits. What does not is added to `cut`, to be read in a tooltip, and the tests are told.
std::string fitted(Ui& ui, const std::string& id, const char* text, float room, std::string& cut);
/// What was cut, then what explains it.
std::string tooltipWith(const std::string& cut, const char* tooltip);
/// Names the field's rectangle for tests and explains it to a resting mouse. `cut`: what of its texts did not fit.
void endRow(Ui& ui, const RowText& text, ImVec2 min, ImVec2 max, const std::string& cut = {});

}  // namespace loomlight
