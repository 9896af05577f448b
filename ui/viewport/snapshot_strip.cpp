#include "ui/viewport/snapshot_strip.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/widgets/fields.h"
#include "ui/words/common_words.h"
#include "ui/words/viewport_words.h"

namespace loomlight {
namespace {

constexpr float kPictureHeight = 72, kButtonsWidth = 196;

void choose(std::vector<std::string>& chosen, const std::string& id) {
  const auto found = std::find(chosen.begin(), chosen.end(), id);
  if (found != chosen.end()) {
    chosen.erase(found);
    return;
  }
  chosen.push_back(id);
  if (chosen.size() > 2) chosen.erase(chosen.begin());
}

void drawItems(Ui& ui, const std::vector<SnapshotItem>& items, SnapshotStripView& view, SnapshotStripEdit& edit) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float height = ui.px(kPictureHeight);
  for (int i = 0; i < static_cast<int>(items.size()); ++i) {
    if (i > 0) ImGui::SameLine(0, ui.px(8));
    const SnapshotItem& item = items[static_cast<size_t>(i)];
    const float width = std::clamp(item.aspect, 0.5f, 3.0f) * height;
    const std::string id = fmt::format("snapshot.item_{}", i);
    const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + width, min.y + height);
    if (ImGui::InvisibleButton(id.c_str(), ImVec2(width, height))) choose(view.chosen, item.id);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) edit.restore = item.id;
    ui.probe.recordItem(id);
    draw.AddRectFilled(min, max, packed(ui.theme.field), ui.px(4));
    if (item.picture)
      draw.AddImageRounded(item.picture, min, max, ImVec2(0, 0), ImVec2(1, 1), IM_COL32_WHITE, ui.px(4));
    const bool chosen = std::find(view.chosen.begin(), view.chosen.end(), item.id) != view.chosen.end();
    if (chosen || ImGui::IsItemHovered())
      draw.AddRect(min, max, packed(chosen ? ui.theme.accent : ui.theme.textQuiet), ui.px(4), 0, ui.px(2));
    const std::string tooltip = item.name + "\n" + words::views::choiceHelp;
    tooltipFor(ui, id.c_str(), min, max, tooltip.c_str());
  }
}

}  // namespace

SnapshotStripEdit snapshotStrip(Ui& ui, const std::vector<SnapshotItem>& items, SnapshotStripView& view) {
  SnapshotStripEdit edit;
  std::erase_if(view.chosen, [&](const std::string& id) {
    return std::none_of(items.begin(), items.end(), [&](const SnapshotItem& item) { return item.id == id; });
  });
  ImGui::SetCursorPosY(ui.px(8));
  ImGui::BeginChild("items", ImVec2(ImGui::GetContentRegionAvail().x - ui.px(kButtonsWidth), ui.px(84)), false,
                    ImGuiWindowFlags_HorizontalScrollbar);
  drawItems(ui, items, view, edit);
  ImGui::EndChild();
  ImGui::SameLine(0, ui.px(8));
  ImGui::BeginGroup();
  const float width = 0.5f * ui.px(kButtonsWidth - 16);
  if (button(ui, "snapshot.keep", words::views::keep.label, width, true, words::views::keep.help)) edit.keep = true;
  ImGui::SameLine(0, ui.px(8));
  const bool one = view.chosen.size() == 1, two = view.chosen.size() == 2;
  if (button(ui, "snapshot.compare", words::views::compare.label, width, two, words::views::compare.help))
    edit.compare = {view.chosen[0], view.chosen[1]};
  if (button(ui, "snapshot.restore", words::views::restore.label, width, one, words::views::restore.help))
    edit.restore = view.chosen[0];
  ImGui::SameLine(0, ui.px(8));
  if (button(ui, "snapshot.remove", words::common::remove, width, one)) edit.remove = view.chosen[0];
  ImGui::EndGroup();
  return edit;
}

}  // namespace loomlight
