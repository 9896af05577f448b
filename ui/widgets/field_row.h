#pragma once

#include "ui/widgets/fields.h"

namespace loomlight {

/// The grid that all rows share: one height, labels in the left part.
inline constexpr float kLabelShare = 0.475f;

struct FieldRow {
  float width = 0;  ///< of the field
  float height = 0;
};

/// Draws the label and puts the cursor where the field begins.
FieldRow beginRow(Ui& ui, const RowText& text);
/// The panel or dialog that is drawn into: Tab does not leave it.
ImGuiID panelOfFields();
/// Tells the tests where a text does not fit its place.
void tellIfClipped(Ui& ui, const std::string& id, const char* text, float room);
/// Names the field's rectangle for tests and explains it to a resting mouse.
void endRow(Ui& ui, const RowText& text, ImVec2 min, ImVec2 max);

}  // namespace loomlight
