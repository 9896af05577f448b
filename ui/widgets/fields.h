#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/model/glossary.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// A labelled row: label on the left, field on the right. Ids are unique within the panel and name the widget for
/// tests.
struct RowText {
  std::string id;
  const char* label;
  const char* tooltip;
  bool standsAlone;  ///< its label takes what it needs, rather than a column that rows share

  RowText(std::string id, const char* label, const char* tooltip = "", bool standsAlone = false)
      : id(std::move(id)), label(label), tooltip(tooltip), standsAlone(standsAlone) {}
  RowText(std::string id, const Word& word, bool standsAlone = false)
      : RowText(std::move(id), word.label, word.help, standsAlone) {}
};

/// How a number is shown and edited. Dragging scrubs it (Shift fine, Ctrl coarse), a click types it.
struct NumberStyle {
  const char* unit = "";
  const char* unitOfOne = "";  ///< in its place behind a 1, where that is another word: "end" of "ends"
  double min = 0, max = 1;
  int decimals = 2;
  bool logarithmic = false;  ///< scrubs by factors; needs min > 0
  const char* none = "";     ///< stands in the place of 0, where that says nothing
  double perPixel = 0;       ///< change per pixel of scrubbing; 0: the range over 300 pixels
  /// Understands further ways to write the value ("30/2 Ne"); nullopt: not one of them.
  std::function<std::optional<double>(std::string_view)> parse;
  const char* otherwise = "";  ///< what these look like, for the message where a text is none of them
  /// Why a text is refused that is one of them; empty: for no reason but the range.
  std::function<std::string(std::string_view)> objection;
};

/// True when the value changed. It stays within [min, max]; text that is no such number is refused beside the field.
bool numberField(Ui& ui, const RowText& text, const NumberStyle& style, double& value);
bool wholeNumberField(Ui& ui, const RowText& text, const char* unit, int min, int max, int& value,
                      const char* unitOfOne = "");

/// Tab and Shift+Tab open the next number of the panel, or the one before; asked once, at the beginning of a frame.
/// A number that was open, held or about to open when its page was left is none of that from then on.
void walkNumbers(Ui& ui);

/// Names as choiceField() takes them; they must outlive it.
std::vector<const char*> choicesOf(const std::vector<std::string>& names);
/// One of a few names, in a list that opens; `chosen` may be -1 for none of them, shown as `otherwise`.
bool choiceField(Ui& ui, const RowText& text, std::span<const char* const> names, int& chosen,
                 const char* otherwise = "");
/// A line of a list that chooses `name`, which is shown whole whatever is in it. Lines with the same name are told
/// apart by what the caller has pushed (ImGui::PushID).
bool listLine(Ui& ui, const std::string& id, const char* name, bool chosen, const char* tooltip = "");
/// One of two to five short names, side by side.
bool segmentField(Ui& ui, const RowText& text, std::span<const char* const> names, int& chosen);
/// The same for an enumeration, whose names are in the order of its enumerators.
template <class Enum>
  requires std::is_enum_v<Enum>
bool segmentField(Ui& ui, const RowText& text, std::span<const char* const> names, Enum& chosen) {
  int index = static_cast<int>(chosen);
  const bool changed = segmentField(ui, text, names, index);
  chosen = static_cast<Enum>(index);
  return changed;
}
/// The same for one of two names: `second`, or else the first.
bool segmentField(Ui& ui, const RowText& text, std::span<const char* const> names, bool& second);
bool switchField(Ui& ui, const RowText& text, bool& value);
/// `whenEmpty`: what stands there, quietly, while there is no text.
bool textField(Ui& ui, const RowText& text, std::string& value, const char* whenEmpty = "");
/// The same; true only when Enter is pressed.
bool enteredField(Ui& ui, const RowText& text, std::string& value, const char* whenEmpty = "");
/// A display colour in linear light, edited in a picker that opens.
bool colourField(Ui& ui, const RowText& text, Rgb& linear);
/// The picker alone, in whatever window is open: for a field that shows more than the colour.
bool colourPicker(Ui& ui, const std::string& id, Rgb& linear);
/// A value that is computed, not edited.
void readout(Ui& ui, const RowText& text, const std::string& value);

/// A button of the width of the panel's field column, or of `width`.
bool button(Ui& ui, const char* id, const char* label, float width = 0, bool enabled = true, const char* tooltip = "");
/// The button that a dialog is for: it stands out, though without a hue.
bool mainButton(Ui& ui, const char* id, const char* label, float width, bool enabled = true, const char* tooltip = "");
/// A square button with a drawn colour; `selected` rings it.
bool swatch(Ui& ui, const char* id, const ImVec4& colour, float size, bool selected, const char* tooltip);

/// Small, quiet heading that groups the rows below it.
void heading(Ui& ui, const char* text);
/// A heading that folds what follows it; a click turns `open`, which is returned.
bool foldingHeading(Ui& ui, const char* id, const char* text, const char* tooltip, bool& open);
/// Quiet explanation, wrapped to the panel; a warning in the colour of one.
void hint(Ui& ui, const std::string& text);
void hint(Ui& ui, const std::string& text, const ImVec4& colour);
/// One line, which keeps its place where there is no text; what has not the room is read in a tooltip. A width of 0:
/// all there is.
void textLine(Ui& ui, const char* id, const std::string& text, const ImVec4& colour, float width = 0);
/// Shows `text` when the mouse has rested on the rectangle for a moment; not while it is pressed, nor after a click.
void tooltipFor(Ui& ui, const char* id, ImVec2 min, ImVec2 max, const char* text);

/// The text of a field is none that it takes: what is wrong with it is said for a few seconds.
void refuseText(Ui& ui, ImGuiID field, std::string problem);
/// Says it below the field, over whatever is there; no more once a number's field is typed into or dragged again.
void showRefusal(Ui& ui, ImGuiID field, ImVec2 min, ImVec2 max);

/// `text`, or as much of it as fits into the width and an ellipsis.
std::string shortened(const std::string& text, float width);

ImVec4 toDisplayColour(const Rgb& linear);
Rgb toLinearColour(const ImVec4& display);

}  // namespace loomlight
