#include "ui/dialogs/colourways_dialog.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/fresh_name.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/model/validate.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/picture_card.h"
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
  const size_t swatches = std::min<size_t>(colours.size(), 6);
  const float pad = ui.px(8), swatch = ui.px(kSwatch), room = swatch * static_cast<float>(swatches);
  const DrawnCard drawn = pictureCard(ui, {.id = fmt::format("colourways.card_{}", index),
                                           .picture = pictureSize_,
                                           .texture = picture,
                                           .name = name,
                                           .isChosen = index == chosen_,
                                           .right = room + pad});
  if (drawn.isPressed) chosen_ = index;
  float x = drawn.corner.x - pad - room;
  const float y = drawn.corner.y + 0.5f * (ImGui::GetFrameHeight() - swatch);
  for (size_t i = 0; i < swatches; ++i, x += swatch)
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, y), ImVec2(x + swatch, y + swatch), packed(colours[i]));
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
    closeModal(open_);
  }
  ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(16) - width);
  if (button(ui, "colourways.close", words::common::close, width) || modalCancelled(ui)) closeModal(open_);
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
