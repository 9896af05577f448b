#include "ui/inspector/cloth_colour.h"

#include <fmt/core.h>

#include <cmath>

#include "core/fabric/model/glossary.h"
#include "ui/inspector/tolerance_rows.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/keys.h"
#include "ui/words/fibre_words.h"

namespace loomlight {
namespace {

constexpr const char* kRow = "fibre.cloth_colour";
constexpr double kSeen = 1.0;  // CIEDE2000: what is less is taken as reached

using State = ClothColourModel::State;
using Wanted = std::optional<WantedColour>;

Wanted wantedOf(const ClothColourView& view, const ClothPart& part) {
  const auto found = view.wanted.find(part);
  return found == view.wanted.end() ? std::nullopt : std::optional(found->second);
}

/// Wanted and reached edge to edge, as one compares swatches; what is not known is an empty field, as black would be a
/// colour.
void chips(Ui& ui, ImVec2 min, ImVec2 max, bool stacked, const Wanted& wanted, const ClothColourModel& model) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const ImVec2 middle(std::floor(0.5f * (min.x + max.x)), std::floor(0.5f * (min.y + max.y)));
  const ImVec2 end(stacked ? max.x : middle.x, stacked ? middle.y : max.y);
  const ImVec2 begin(stacked ? min.x : middle.x, stacked ? middle.y : min.y);
  draw.AddRectFilled(min, max, packed(ui.theme.field), rounding);
  if (wanted)
    draw.AddRectFilled(min, end, packed(toDisplayColour(wanted->colour)), rounding,
                       stacked ? ImDrawFlags_RoundCornersTop : ImDrawFlags_RoundCornersLeft);
  if (model.state == State::known)
    draw.AddRectFilled(begin, max, packed(toDisplayColour(model.colour)), rounding,
                       stacked ? ImDrawFlags_RoundCornersBottom : ImDrawFlags_RoundCornersRight);
  draw.AddRect(min, max, packed(ui.theme.text, 0.18f), rounding);
}

std::string differenceText(const Wanted& wanted, const ClothColourModel& model) {
  if (!wanted || model.state != State::known) return words::clothColour::noDifference;
  return fmt::format(words::clothColour::difference, model.difference);
}

/// What can be done about a difference: take what there is, or dye once more where the cloth has become another one.
void remedy(Ui& ui, const char* id, float width, const ClothPart& part, const Wanted& wanted,
            const ClothColourModel& model, ClothColourView& view) {
  // What the cloth was before its last edit is no colour to take: it would undo that.
  const bool known = wanted && model.state == State::known && model.isCurrent;
  const bool isOut = model.tooLight || model.tooDark;
  const bool again = known && !isOut && model.difference >= kSeen;
  const bool helps = known && (isOut || again);
  const Word& word = again ? words::dyeAgain : words::takeNearest;
  ui.probe.fact(id, helps ? word.label : "");
  if (!button(ui, id, word.label, width, helps, word.help)) return;
  if (again)
    view.want(part, *wanted);
  else
    view.takeNearest(part, model.colour);
}

/// The picker, and beside it what is wanted and what comes of it.
void picker(Ui& ui, const ClothPart& part, const Wanted& wanted, const ClothColourModel& model, ClothColourView& view) {
  if (!ImGui::BeginPopup("picker")) return;
  ImGui::BeginGroup();
  Rgb colour = wanted ? wanted->colour : model.colour;
  if (colourPicker(ui, kRow, colour)) view.want(part, {colour, {}, ""});
  ImGui::EndGroup();
  const float high = ImGui::GetItemRectSize().y, wide = ui.px(112);
  ImGui::SameLine(0, ui.px(12));
  ImGui::BeginGroup();
  const float below = 2 * ImGui::GetFrameHeightWithSpacing();
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + wide, min.y + high - below);
  chips(ui, min, max, true, wanted, model);
  ImGui::Dummy(ImVec2(wide, max.y - min.y));
  ui.probe.record("fibre.cloth_colour_chips", min, max);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(differenceText(wanted, model).c_str());
  remedy(ui, "fibre.cloth_colour_take", wide, part, wanted, model, view);
  ImGui::EndGroup();
  if (keyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void wantedRow(Ui& ui, const ClothPart& part, const Wanted& wanted, const ClothColourModel& model,
               ClothColourView& view) {
  const RowText text{kRow, words::inThisCloth};
  const FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + row.width, min.y + row.height);
  ImGui::PushID(kRow);
  const bool known = model.state == State::known;
  if (ImGui::InvisibleButton("##chips", ImVec2(row.width, row.height)) && known) ImGui::OpenPopup("picker");
  chips(ui, min, max, false, wanted, model);
  ui.probe.record("fibre.cloth_colour_reached", ImVec2(std::floor(0.5f * (min.x + max.x)), min.y), max);
  picker(ui, part, wanted, model, view);
  ImGui::PopID();
  endRow(ui, text, min, max, row.cut);
}

/// How far off it is, and what can be done about that.
void differenceRow(Ui& ui, const ClothPart& part, const Wanted& wanted, const ClothColourModel& model,
                   ClothColourView& view) {
  const std::string said = differenceText(wanted, model);
  const RowText text{"fibre.cloth_colour_difference", said.c_str(), words::difference.help};
  ui.probe.fact(text.id, said);
  const FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + row.width, min.y + row.height);
  remedy(ui, "fibre.cloth_colour_nearest", row.width, part, wanted, model, view);
  endRow(ui, text, min, ImVec2(min.x, max.y), row.cut);
}

std::string remark(const ClothPart& part, const ClothColourModel& model, const Wanted& wanted) {
  namespace said = words::clothColour;
  switch (model.state) {
    case State::measuring:
      return said::measuring;
    case State::hidden:
      return part.kind == ClothPart::Kind::yarn ? said::yarnIsHidden : said::fibreIsHidden;
    case State::failed:
      return said::failed;
    case State::known:
      break;
  }
  if (!wanted) return said::pick;
  const std::string lamp = lampWord(model.present ? model.present->lamp : StandardIlluminant::d65);
  if (model.tooLight && model.tooDark) return fmt::format(said::notToBeHad, lamp);
  if (model.tooLight) return fmt::format(said::tooLight, lamp);
  if (model.tooDark) return fmt::format(said::tooDark, lamp);
  const bool reached = model.difference < kSeen;
  if (wanted->measured && reached) return fmt::format(said::asMeasured, wanted->name);
  return reached ? said::reached : said::clothChanged;
}

/// Whether a fibre takes the dye, a yarn, or the woven piece.
void dyedRow(Ui& ui, ClothColourView& view) {
  static constexpr ClothPart::Kind kKinds[] = {ClothPart::Kind::fibre, ClothPart::Kind::yarn, ClothPart::Kind::piece};
  int chosen = 0;
  while (kKinds[chosen] != view.dyes) ++chosen;
  if (segmentField(ui, {"fibre.dyed", words::dyedAs}, words::clothColour::dyed, chosen)) view.refusal.clear();
  view.dyes = kKinds[chosen];
}

/// A colour as it is written or called.
void codeRow(Ui& ui, bool canBeDyed, ClothColourView& view) {
  const char* const example = view.book ? words::clothColour::codeOrNameLooksLike : words::clothColour::codeLooksLike;
  const RowText text{"fibre.colour_code", words::colourCode};
  if (!canBeDyed) ImGui::BeginDisabled();
  if (enteredField(ui, text, view.code, example) && canBeDyed && !view.code.empty()) view.entered = view.code;
  if (!canBeDyed) ImGui::EndDisabled();
}

/// As many lines are kept free as a remark may take, so that what is said moves nothing.
void remarkLines(Ui& ui, const std::string& said) {
  const float top = ImGui::GetCursorPosY();
  const float lines = ImGui::GetContentRegionAvail().x < ui.px(280) ? 3 : 2;
  ImGui::PushFont(ui.fonts.small);
  const float room = lines * ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y;
  ImGui::PopFont();
  hint(ui, said);
  ui.probe.fact("fibre.cloth_colour_remark", said);
  ImGui::SetCursorPosY(top + room);
}

}  // namespace

void clothColourRows(Ui& ui, const ClothPart& part, const ClothColourModel& model, ClothColourView& view) {
  const Wanted wanted = wantedOf(view, part);
  wantedRow(ui, part, wanted, model, view);
  differenceRow(ui, part, wanted, model, view);
  dyedRow(ui, view);
  const bool canBeDyed = model.state == State::known || model.state == State::measuring;
  codeRow(ui, canBeDyed, view);
  remarkLines(ui, view.refusal.empty() ? remark(part, model, wanted) : view.refusal);
  bookRow(ui, view.books);
  const BookColour* const chosen = view.book ? colourBookRows(ui, *view.book, view.search) : nullptr;
  toleranceRows(ui, model, view.tolerance_cmc);
  if (!chosen || !canBeDyed) return;
  view.want(part, {chosen->linear, chosen->measured, chosen->name});
  view.code = chosen->name;
}

}  // namespace loomlight
