#include "ui/inspector/visibility_section.h"

#include <fmt/core.h>

#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/words/yarn_words.h"

namespace loomlight {
namespace {

/// The squares, with the angle that each is of.
void drawSquares(Ui& ui, const VisibilityModel& model) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const int count = model.columns * model.rows;
  const auto columns = static_cast<float>(model.columns), rows = static_cast<float>(model.rows);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float all = ImGui::GetContentRegionAvail().x, gap = ui.px(6);
  const float side = std::floor((all - (columns - 1) * gap) / columns);
  ImGui::PushFont(ui.fonts.small);
  const float label = ImGui::GetFontSize() + ui.px(2), row = side + label + ui.px(4);
  for (int i = 0; i < count; ++i) {
    const int column = i % model.columns, line = i / model.columns;
    const auto x = static_cast<float>(column), y = static_cast<float>(line);
    const ImVec2 min(corner.x + x * (side + gap), corner.y + y * row), max(min.x + side, min.y + side);
    draw.AddRectFilled(min, max, packed(ui.theme.field));
    if (model.picture)
      draw.AddImage(model.picture, min, max, ImVec2(x / columns, y / rows), ImVec2((x + 1) / columns, (y + 1) / rows));
    const std::string angle = fmt::format("{:.0f}\xC2\xB0", 180.0 * i / (count - 1));
    const float width = ImGui::CalcTextSize(angle.c_str()).x;
    draw.AddText(ImVec2(min.x + 0.5f * (side - width), max.y + ui.px(2)), packed(ui.theme.textQuiet), angle.c_str());
  }
  ImGui::PopFont();
  ImGui::Dummy(ImVec2(all, rows * row));
  ui.probe.recordItem("visibility.picture");
  tooltipFor(ui, "visibility.picture", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
             words::yarnPage::visibilityAxes);
}

}  // namespace

void visibilitySection(Ui& ui, const VisibilityModel& model, bool& open) {
  const bool wasOpen = open;
  const Word& word = words::yarnPage::visibility;
  if (!foldingHeading(ui, "visibility.fold", word.label, word.help, open)) return;
  drawSquares(ui, model);
  if (!model.error.empty()) {
    hint(ui, model.error);
  } else if (!model.picture && !model.baking) {
    hint(ui, words::yarnPage::visibilityBegins);
  } else if (model.baking) {
    hint(ui, fmt::format(words::yarnPage::visibilityProgress, 100 * model.progress));
  } else {
    hint(ui, fmt::format(words::yarnPage::visibilityDone, model.rays * 1e-6));
  }
  if (!wasOpen) ImGui::SetScrollHereY(1);
}

}  // namespace loomlight
