#include "ui/dialogs/colourways_dialog.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/fresh_name.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/model/validate.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/dialog_words.h"

namespace loomlight {
namespace {

constexpr float kNarrowest = 200, kAspect = 232.0f / 168, kWidestAspect = 2, kSwatch = 14, kGap = 12;

/// A name that no colourway has yet.
std::string nameFor(const Fabric& fabric, const std::string& wish) {
  return freshName(wish, [&](const std::string& name) {
    return std::any_of(fabric.colourways.begin(), fabric.colourways.end(),
                       [&](const Colourway& colourway) { return colourway.name == name; });
  });
}

}  // namespace

/// As large as so many cards beside and below each other can be; where they would be too small, they scroll.
void ColourwaysDialog::fitPictures(const Ui& ui, ImVec2 room, int count) {
  const float gap = ui.px(kGap), line = ImGui::GetFrameHeight();
  ImVec2 best(0, 0);
  for (int perLine = 1; perLine <= count; ++perLine) {
    const int lines = (count + perLine - 1) / perLine;
    const auto across = static_cast<float>(perLine), down = static_cast<float>(lines);
    const float width = (room.x - gap * (across - 1)) / across, height = (room.y - gap * (down - 1)) / down - line;
    const ImVec2 size(std::min(width, kWidestAspect * height), std::min(height, width / kAspect));
    if (size.x * size.y <= best.x * best.y || size.y <= 0) continue;
    best = size;
    perLine_ = perLine;
  }
  if (best.x < ui.px(kNarrowest)) {
    best = ImVec2(ui.px(kNarrowest), ui.px(kNarrowest) / kAspect);
    perLine_ = std::max(1, static_cast<int>((room.x - ImGui::GetStyle().ScrollbarSize + gap) / (best.x + gap)));
  }
  pictureSize_ = ImVec2(std::floor(best.x), std::floor(best.y));
}

void ColourwaysDialog::card(Ui& ui, int index, const char* name, ImTextureID picture,
                            const std::vector<ImVec4>& colours) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = pictureSize_.x, height = pictureSize_.y, line = ImGui::GetFrameHeight();
  const std::string id = fmt::format("colourways.card_{}", index);
  const ImVec2 max(min.x + width, min.y + height + line);
  if (ImGui::InvisibleButton(id.c_str(), ImVec2(width, height + line))) chosen_ = index;
  ui.probe.recordItem(id);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, packed(ui.theme.field), ui.px(4));
  const ImVec2 corner(max.x, min.y + height);
  if (picture)
    draw.AddImageRounded(picture, min, corner, ImVec2(0, 0), ImVec2(1, 1), IM_COL32_WHITE, ui.px(4),
                         ImDrawFlags_RoundCornersTop);
  else
    draw.AddRectFilled(min, corner, packed(ui.theme.surround), ui.px(4), ImDrawFlags_RoundCornersTop);
  const float pad = ui.px(8), swatch = ui.px(kSwatch);
  float x = max.x - pad - swatch * static_cast<float>(std::min<size_t>(colours.size(), 6));
  const float y = corner.y + 0.5f * (line - swatch);
  std::string cut;
  const std::string text = fitted(ui, id, name, x - min.x - 2 * pad, cut);
  draw.AddText(ImVec2(min.x + pad, corner.y + 0.5f * (line - ImGui::GetFontSize())), packed(ui.theme.text),
               text.c_str());
  for (size_t i = 0; i < std::min<size_t>(colours.size(), 6); ++i, x += swatch)
    draw.AddRectFilled(ImVec2(x, y), ImVec2(x + swatch, y + swatch), packed(colours[i]));
  if (index == chosen_ || ImGui::IsItemHovered())
    draw.AddRect(min, max, packed(index == chosen_ ? ui.theme.accent : ui.theme.textQuiet), ui.px(4), 0, ui.px(2));
  tooltipFor(ui, id.c_str(), min, max, cut.c_str());
}

void ColourwaysDialog::cards(Ui& ui, const Fabric& fabric, const ColourwayLooks& looks, ImVec2 size) {
  ImGui::BeginChild("cards", size);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(kGap), ui.px(kGap)));
  const int count = static_cast<int>(fabric.colourways.size()) + 1;
  fitPictures(ui, size, count);
  for (int i = 0; i < count; ++i) {
    if (i % perLine_ != 0) ImGui::SameLine();
    const Colourway* const colourway = i > 0 ? &fabric.colourways[static_cast<size_t>(i - 1)] : nullptr;
    const auto look = static_cast<size_t>(i);
    card(ui, i, colourway ? colourway->name.c_str() : words::colourways::asItIsNow, looks.pictures[look],
         looks.yarnColours[look]);
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

std::optional<Fabric> ColourwaysDialog::actions(Ui& ui, const Fabric& fabric) {
  const bool kept = chosen_ > 0;
  const bool room = static_cast<int>(fabric.colourways.size()) < kMaxKinds;
  const auto index = static_cast<size_t>(std::max(0, chosen_ - 1));
  std::optional<Fabric> edited;
  const auto edit = [&]() -> Fabric& { return edited ? *edited : edited.emplace(fabric); };
  // The row is there for the cloth as it is too, so that a choice moves nothing.
  std::string name = kept ? fabric.colourways[index].name : words::colourways::asItIsNow;
  ImGui::BeginChild("name", ImVec2(ui.px(412), ImGui::GetFrameHeight()));
  if (!kept) ImGui::BeginDisabled();
  if (textField(ui, {"colourways.name", words::colourways::name, true}, name) && kept)
    edit().colourways[index].name = name;
  if (!kept) ImGui::EndDisabled();
  ImGui::EndChild();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  const float width = ui.px(132);
  if (button(ui, "colourways.keep", words::colourways::keep.label, width, room, words::colourways::keep.help)) {
    edit().colourways.push_back(colourwayOf(fabric, nameFor(fabric, words::colourways::newName)));
    chosen_ = static_cast<int>(edit().colourways.size());
  }
  ImGui::SameLine();
  if (button(ui, "colourways.use", words::colourways::use.label, width, kept, words::colourways::use.help))
    edited = inColourway(fabric, fabric.colourways[index]);
  ImGui::SameLine();
  if (button(ui, "colourways.copy", words::colourways::duplicate.label, width, kept && room,
             words::colourways::duplicate.help)) {
    Colourway copy = fabric.colourways[index];
    copy.name = nameFor(fabric, copy.name);
    edit().colourways.insert(edit().colourways.begin() + static_cast<ptrdiff_t>(index) + 1, std::move(copy));
    ++chosen_;
  }
  ImGui::SameLine();
  if (button(ui, "colourways.remove", words::common::remove, width, kept)) {
    edit().colourways.erase(edit().colourways.begin() + static_cast<ptrdiff_t>(index));
    --chosen_;
  }
  ImGui::SameLine();
  if (button(ui, "colourways.print", words::colourways::print.label, width, true, words::colourways::print.help)) {
    printWanted_ = true;
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(16) - width);
  if (button(ui, "colourways.close", words::common::close, width) || modalCancelled(ui)) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  return edited;
}

std::optional<Fabric> ColourwaysDialog::draw(Ui& ui, const Fabric& fabric, const ColourwayLooks& looks) {
  if (!open_) return std::nullopt;
  chosen_ = std::clamp(chosen_, 0, static_cast<int>(fabric.colourways.size()));
  if (!beginModal(ui, words::colourways::title, ImGui::GetIO().DisplaySize, open_, opening_)) return std::nullopt;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  cards(ui, fabric, looks, ImVec2(room.x, room.y - 2 * ImGui::GetFrameHeightWithSpacing() - ui.px(16)));
  std::optional<Fabric> edited = actions(ui, fabric);
  endModal();
  return edited;
}

}  // namespace loomlight
