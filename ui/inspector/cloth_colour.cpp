#include "ui/inspector/cloth_colour.h"

#include <fmt/core.h>

#include <cmath>

#include "core/fabric/model/glossary.h"
#include "ui/widgets/field_row.h"

namespace loomlight {
namespace {

/// Wanted on the left, what is there on the right, edge to edge, as one compares swatches.
void comparisonRow(Ui& ui, const std::optional<WantedColour>& wanted, const ClothColourModel& model) {
  const RowText text{"fibre.cloth_colour_reached", "Wanted, reached",
                     "The colour asked for on the left, the cloth's on the right, seen from straight above in white "
                     "light from the sky over black."};
  const FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + row.width, min.y + row.height);
  const float middle = std::floor(0.5f * (min.x + max.x));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(min, max, packed(ui.theme.field), rounding);
  const bool known = model.state == ClothColourModel::State::known;
  if (wanted)
    draw.AddRectFilled(min, ImVec2(middle, max.y), packed(toDisplayColour(wanted->colour)), rounding,
                       ImDrawFlags_RoundCornersLeft);
  if (known)
    draw.AddRectFilled(ImVec2(middle, min.y), max, packed(toDisplayColour(model.colour)), rounding,
                       ImDrawFlags_RoundCornersRight);
  ImGui::Dummy(ImVec2(row.width, row.height));
  endRow(ui, text, min, max);
}

std::string remark(const ClothColourModel& model, const std::optional<WantedColour>& wanted) {
  switch (model.state) {
    case ClothColourModel::State::measuring:
      return "Measuring what light does in this cloth.";
    case ClothColourModel::State::hidden:
      return "This fibre never lies on the face, so it shows no colour.";
    case ClothColourModel::State::failed:
      return "The colour of this cloth cannot be measured.";
    case ClothColourModel::State::known:
      break;
  }
  if (!wanted) return "Pick the colour that the cloth should have, or drop a measured swatch here.";
  const std::string off = fmt::format("off by {:.1f} (CIEDE2000)", model.difference);
  if (model.tooLight && model.tooDark) return "Not to be had of this fibre; the nearest is " + off + ".";
  if (model.tooLight) return "Lighter than this cloth can be, light comes through: the nearest is " + off + ".";
  if (model.tooDark) return "Darker than fibres can be, their surface reflects: the nearest is " + off + ".";
  if (wanted->measured && model.difference < 1) return "As " + wanted->name + " was measured: " + off + ".";
  return model.difference < 1 ? "Reached: " + off + "." : "The cloth has changed since, and is " + off + ".";
}

/// Whether a yarn takes the dye or the woven piece.
void dyedRow(Ui& ui, ClothColourView& view) {
  static constexpr const char* kNames[] = {"This fibre", "Piece"};
  int chosen = view.piece ? 1 : 0;
  if (segmentField(ui, {"fibre.dyed", words::dyedAs.label, words::dyedAs.help}, kNames, chosen)) view.refusal.clear();
  view.piece = chosen == 1;
}

/// A colour as it is written or called.
void codeRow(Ui& ui, ClothColourView& view) {
  const char* const example = view.book ? "#1a2b3c, Lab 30 5 -12 or a name" : "#1a2b3c or Lab 30 5 -12";
  const RowText text{"fibre.colour_code", words::colourCode.label, words::colourCode.help};
  if (enteredField(ui, text, view.code, example) && !view.code.empty()) view.entered = view.code;
}

}  // namespace

void clothColourRows(Ui& ui, int fibre, size_t fibres, const ClothColourModel& model, ClothColourView& view) {
  if (fibres > 1) dyedRow(ui, view);
  const int what = view.dyed(fibre, fibres);
  const auto found = view.wanted.find(what);
  const std::optional<WantedColour> wanted = found == view.wanted.end() ? std::nullopt : std::optional(found->second);
  const bool known = model.state == ClothColourModel::State::known;
  // Until the cloth's colour is known the swatch is an empty field: black would be a colour.
  Rgb colour = wanted ? wanted->colour : known ? model.colour : toLinearColour(ui.theme.field);
  if (colourField(ui, {"fibre.cloth_colour", words::inThisCloth.label, words::inThisCloth.help}, colour) && known) {
    view.want(what, {colour, {}, ""});
    view.refusal.clear();
  }
  if (known) codeRow(ui, view);
  comparisonRow(ui, wanted, model);
  // Two lines are kept free, so that what is said moves nothing.
  const float top = ImGui::GetCursorPosY();
  ImGui::PushFont(ui.fonts.small);
  const float room = 2 * ImGui::GetTextLineHeightWithSpacing();
  ImGui::PopFont();
  const std::string said = view.refusal.empty() ? remark(model, wanted) : view.refusal;
  hint(ui, said);
  ui.probe.fact("fibre.cloth_colour_remark", said);
  ImGui::SetCursorPosY(top + room);
  if (!view.book || !known) return;
  if (const BookColour* chosen = colourBookRows(ui, *view.book, view.search)) {
    view.want(what, {chosen->linear, chosen->measured, chosen->name});
    view.refusal.clear();
    view.code = chosen->name;
  }
}

}  // namespace loomlight
