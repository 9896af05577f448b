#include "ui/dialogs/colour_difference_dialog.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/model/booth_lamps.h"
#include "ui/inspector/tolerance_rows.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/booth_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

namespace said = words::booth;

void side(Ui& ui, const std::string& id, const Word& word, const ColourDifferenceModel& model, ColouredYarn& of) {
  choiceField(ui, {id, word}, choicesOf(model.yarns), of.yarn);
  choiceField(ui, {id + "_colourway", said::inColourway}, choicesOf(model.colourways), of.colourway);
}

/// Standard and sample edge to edge, as one compares swatches.
void chips(Ui& ui, const ColourDifferenceModel::UnderLamp* under) {
  const ImVec2 min = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight());
  const ImVec2 max(min.x + size.x, min.y + size.y), middle(min.x + 0.5f * size.x, max.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (under) {
    draw.AddRectFilled(min, middle, packed(under->standard.colour));
    draw.AddRectFilled(ImVec2(middle.x, min.y), max, packed(under->sample.colour));
  } else {
    draw.AddRect(min, max, packed(ui.theme.line));  // what is not known is no white
  }
  ImGui::Dummy(size);
}

std::string labText(const ColourDifferenceModel::Side& of) {
  return fmt::format("{:.1f}  {:.1f}  {:.1f}", of.L, of.a, of.b);
}

void cell(Ui& ui, const std::string& id, const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  ui.probe.fact(id, text);
}

void lampRow(Ui& ui, StandardIlluminant lamp, const ColourDifferenceModel::UnderLamp* under, double tolerance_cmc) {
  const std::string id = "difference." + lampWord(lamp);
  const auto known = [&](const auto& text) { return under ? text() : std::string(words::panels::none); };
  cell(ui, id, lampLabel(lamp));
  ImGui::TableNextColumn();
  chips(ui, under);
  cell(ui, id + "_standard", known([&] { return labText(under->standard); }));
  cell(ui, id + "_sample", known([&] { return labText(under->sample); }));
  cell(ui, id + "_ciede2000", known([&] { return fmt::format("{:.2f}", under->ciede2000); }));
  cell(ui, id + "_cmc", known([&] { return verdictText(under->cmc, tolerance_cmc); }));
  const bool changes = lamp != kBoothLamps.front();
  cell(ui, id + "_metamerism", !changes ? "" : known([&] { return fmt::format("{:.2f}", under->metamerism); }));
}

void table(Ui& ui, const ColourDifferenceModel& model, double tolerance_cmc) {
  struct Column {
    const char* label;
    float width;  ///< at scale 1
  };
  constexpr Column kColumns[] = {{said::lamp, 132},           {said::sideBySide, 96},      {said::standardLab, 140},
                                 {said::sampleLab, 140},      {said::ciede2000Column, 84}, {said::cmcColumn, 104},
                                 {said::metamerism.label, 96}};
  if (!ImGui::BeginTable("difference", static_cast<int>(std::size(kColumns)), ImGuiTableFlags_SizingFixedFit)) return;
  for (const Column& column : kColumns)
    ImGui::TableSetupColumn(column.label, ImGuiTableColumnFlags_WidthFixed, ui.px(column.width));
  ImGui::TableNextRow();
  for (const Column& column : kColumns) {
    ImGui::TableNextColumn();
    ImGui::TextColored(ui.theme.textQuiet, "%s", column.label);
  }
  for (size_t i = 0; i < kBoothLamps.size(); ++i) {
    ImGui::TableNextRow();
    lampRow(ui, kBoothLamps[i], i < model.lamps.size() ? &model.lamps[i] : nullptr, tolerance_cmc);
  }
  ImGui::EndTable();
}

}  // namespace

const ColourPair& ColourDifferenceDialog::pairOf(const Fabric& fabric) {
  for (ColouredYarn* const of : {&pair_.standard, &pair_.sample}) {
    of->yarn = std::min(of->yarn, static_cast<int>(fabric.yarns.size()) - 1);
    of->colourway = std::min(of->colourway, static_cast<int>(fabric.colourways.size()));
  }
  return pair_;
}

void ColourDifferenceDialog::draw(Ui& ui, const ColourDifferenceModel& model, double& tolerance_cmc) {
  if (!open_) return;
  if (!beginModal(ui, said::differenceTitle, ImVec2(ui.px(900), 0), open_, opening_)) return;
  beginModalRows(ui, "difference.rows");
  side(ui, "difference.standard", said::standard, model, pair_.standard);
  side(ui, "difference.sample", said::sample, model, pair_.sample);
  toleranceField(ui, "difference.tolerance", tolerance_cmc);
  ImGui::Dummy(ImVec2(0, ui.px(8)));
  table(ui, model, tolerance_cmc);
  const std::string remark = model.lamps.empty() ? model.remark : fmt::format(said::howKnown, model.error);
  textLine(ui, "difference.remark", remark, ui.theme.textQuiet);
  ui.probe.fact("difference.remark", remark);
  endModalRows("difference.rows");
  closeButtonBelow(ui, "difference.close", open_);
  endModal();
}

}  // namespace loomlight
