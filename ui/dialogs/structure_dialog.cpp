#include "ui/dialogs/structure_dialog.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/weave/weave_code.h"
#include "core/fabric/yarn/derived.h"
#include "ui/draft/structure_thumbnail.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/dialog_words.h"

namespace loomlight {
namespace {

/// In colour where the structure is one of colours.
void drawMade(Ui& ui, const MadeStructure& made, const ImVec4 (&darkLight)[2], ImVec2 min, float size, int cells) {
  if (made.warpColours.empty()) return drawThumbnail(ui, made.weave, min, size, cells);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float cell = size / static_cast<float>(cells);
  const auto colourAt = [](const std::vector<int>& colours, int i) {
    return colours[static_cast<size_t>(i) % colours.size()];
  };
  for (int pick = 0; pick < cells; ++pick)
    for (int end = 0; end < cells; ++end) {
      const int yarn =
          made.weave.warpOver(pick, end) ? colourAt(made.warpColours, end) : colourAt(made.weftColours, pick);
      const float x = min.x + cell * static_cast<float>(end), y = min.y + size - cell * static_cast<float>(pick + 1);
      draw.AddRectFilled(ImVec2(x, y), ImVec2(x + cell, y + cell), packed(darkLight[yarn]));
    }
}

/// Two yarns that an eye hardly tells apart would hide what an effect of colours is.
bool lookAlike(const ImVec4 (&darkLight)[2]) {
  constexpr float kHardlySeen = 0.06f;  // of the display's range
  const ImVec4 &a = darkLight[0], &b = darkLight[1];
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) < kHardlySeen;
}

/// What a structure is in numbers.
std::string factsOf(const Weave& weave) {
  const Floats f = floats(weave);
  std::string facts = fmt::format(words::structures::facts, weave.ends(), weave.picks(), f.warp(), f.weft());
  if (const auto draft = smallestDraft(weave, 256)) facts += fmt::format(words::structures::andShafts, draft->shafts);
  if (const auto code = isoWeaveCode(weave)) facts += fmt::format(words::structures::andIsoCode, *code);
  return facts;
}

/// These, or why there is none: three lines always, so that the rows below stay where they are.
void sayFacts(Ui& ui, const std::string& facts, const std::string& problem) {
  const bool fails = !problem.empty();
  ImGui::BeginChild("structures.facts", ImVec2(0, 3 * ui.fonts.small->FontSize));
  hint(ui, fails ? problem : facts, fails ? ui.theme.warning : ui.theme.textQuiet);
  ImGui::EndChild();
}

bool parameterRow(Ui& ui, const StructureParameter& parameter, int& value) {
  const RowText text{std::string("structures.") + parameter.name, parameter.name, parameter.meaning};
  if (!parameter.choices.empty()) return segmentField(ui, text, parameter.choices, value);
  return wholeNumberField(ui, text, "", parameter.min, parameter.max, value);
}

}  // namespace

void StructureDialog::choose(size_t kind) {
  kind_ = kind;
  values_ = structureLibrary()[kind].startValues();
  make();
}

/// The kind that is chosen, with its parameters as they are.
void StructureDialog::make() {
  made_ = structureLibrary()[kind_].make(values_);
  facts_ = factsOf(made_.weave);
}

void StructureDialog::drawKinds(Ui& ui, const ImVec4 (&darkLight)[2], float width, float height, bool& apply) {
  const std::vector<StructureKind>& library = structureLibrary();
  if (thumbnails_.empty())
    for (const StructureKind& kind : library) thumbnails_.push_back(kind.make(kind.startValues()));
  ImGui::BeginChild("structures.kinds", ImVec2(width, height));
  const float size = ui.px(64), gap = ui.px(24), line = ui.px(94);
  const int perLine = std::max(1, static_cast<int>((width - ui.px(16) + gap) / (size + gap)));
  const ImVec2 corner = ImGui::GetCursorPos();
  for (size_t i = 0; i < library.size(); ++i) {
    const int column = static_cast<int>(i) % perLine, row = static_cast<int>(i) / perLine;
    const ImVec2 at(corner.x + ui.px(6) + static_cast<float>(column) * (size + gap),
                    corner.y + ui.px(4) + static_cast<float>(row) * line);
    ImGui::SetCursorPos(at);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    constexpr int kCells = 16;
    if (structureThumbnail(ui, std::string("library/") + library[i].name, {library[i].about, thumbnails_[i].weave},
                           size, kCells, i == kind_))
      choose(i);
    const bool coloured = !thumbnails_[i].warpColours.empty();
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) apply = true;
    if (coloured) drawMade(ui, thumbnails_[i], darkLight, min, size, 2 * kCells);
    ImGui::PushFont(ui.fonts.small);
    const float text = ImGui::CalcTextSize(library[i].name).x;
    ImGui::SetCursorPos(ImVec2(at.x + 0.5f * (size - text), at.y + size + ui.px(5)));
    ImGui::TextUnformatted(library[i].name);
    ImGui::PopFont();
  }
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  hint(ui, unwovenStructures());
  ImGui::EndChild();
}

void StructureDialog::drawChosen(Ui& ui, const std::optional<CellRect>& selection, const ImVec4 (&darkLight)[2],
                                 bool alike) {
  const StructureKind& kind = structureLibrary()[kind_];
  const float side = ui.px(192);
  drawMade(ui, made_, darkLight, ImGui::GetCursorScreenPos(), side, 32);
  ImGui::Dummy(ImVec2(side, side));
  ImGui::PushFont(ui.fonts.strong);
  textLine(ui, "structures.title", made_.name, ui.theme.text);
  ImGui::PopFont();
  sayFacts(ui, facts_, made_.problem);
  ui.probe.fact("structures.name", made_.name);
  ui.probe.fact("structures.problem", made_.problem);
  for (size_t i = 0; i < kind.parameters.size(); ++i)
    if (parameterRow(ui, kind.parameters[i], values_[i])) make();
  hint(ui, kind.about);
  const bool hidden = alike && !made_.warpColours.empty();
  ui.probe.fact("structures.alike", hidden ? "yes" : "no");
  if (hidden) hint(ui, words::structures::alikeYarns, ui.theme.warning);
  hint(ui, selection ? fmt::format(words::structures::fillsSelection, selection->ends, selection->picks)
                     : std::string(words::structures::fillsRepeat));
}

std::optional<MadeStructure> StructureDialog::draw(Ui& ui, const std::optional<CellRect>& selection,
                                                   const ImVec4 (&darkLight)[2]) {
  if (!open_ || !beginModal(ui, words::structures::title, ImVec2(ui.px(800), 0), open_, opening_)) return std::nullopt;
  bool apply = false;
  const float height = std::min(ui.px(520), roomAboveButtons(ui));
  const bool alike = lookAlike(darkLight);
  const ImVec4 shown[2] = {alike ? ui.theme.ink : darkLight[0], alike ? ui.theme.paper : darkLight[1]};
  drawKinds(ui, shown, ui.px(464), height, apply);
  ImGui::SameLine(0, ui.px(16));
  ImGui::BeginChild("structures.chosen", ImVec2(0, height));
  drawChosen(ui, selection, shown, alike);
  ImGui::EndChild();
  const float width = ui.px(120);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ui.px(24));
  if (button(ui, "structures.close", words::common::close, width) || modalCancelled(ui)) closeModal(open_);
  ImGui::SameLine();
  apply |=
      mainButton(ui, "structures.apply", words::structures::apply, width, made_.problem.empty()) || modalConfirmed(ui);
  endModal();
  if (!apply || !made_.problem.empty()) return std::nullopt;
  return made_;
}

}  // namespace loomlight
