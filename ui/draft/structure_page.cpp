#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/fabric/weave/structure_edit.h"
#include "ui/draft/draft_panel.h"
#include "ui/draft/structure_thumbnail.h"
#include "ui/widgets/fields.h"
#include "ui/words/draft_words.h"

namespace loomlight {
namespace {

constexpr int kCells = 10;  // of a thumbnail, along each side

/// Thumbnails side by side, each with its name below, which takes a second line where it must.
struct ThumbnailGrid {
  float size = 0;             ///< of a thumbnail, along each side
  float gap = 0;              ///< between slots
  float lineGap = 0;          ///< below a name: more than above it, so that it is seen whose it is
  float slotWidth = 0;        ///< what a name has
  int perLine = 1;            ///< slots
  std::vector<float> tops{};  ///< of the lines, and last where they end

  ImVec2 at(int i) const {
    return {static_cast<float>(i % perLine) * (slotWidth + gap), tops[static_cast<size_t>(i / perLine)]};
  }
};

/// The two lines that a name stands in where it is too long for one; the second may be empty.
std::pair<std::string, std::string> halves(const std::string& name) {
  const size_t space = name.find(' ');
  if (space == std::string::npos) return {name, ""};
  return {name.substr(0, space), name.substr(space + 1)};
}

/// What the widest line of a name needs that stands in two.
float widestHalf(const std::vector<Structure>& palette) {
  float widest = 0;
  for (const Structure& structure : palette) {
    const auto [first, second] = halves(structure.name);
    widest = std::max({widest, ImGui::CalcTextSize(first.c_str()).x, ImGui::CalcTextSize(second.c_str()).x});
  }
  return std::ceil(widest);
}

/// The name in one line, or in two where it is too long for one.
std::vector<std::string> linesOf(const std::string& name, float width) {
  if (ImGui::CalcTextSize(name.c_str()).x <= width) return {name};
  const auto [first, second] = halves(name);
  if (second.empty()) return {shortened(first, width)};
  return {shortened(first, width), shortened(second, width)};
}

/// `name`: the least that a name has, in pixels.
ThumbnailGrid gridOf(Ui& ui, const std::vector<Structure>& palette, float size, float name, float room) {
  ThumbnailGrid grid{size, ui.px(3), ui.px(5)};
  const float least = std::max(size, name);
  grid.perLine = std::max(1, static_cast<int>((room + grid.gap) / (least + grid.gap)));
  grid.slotWidth = (room + grid.gap) / static_cast<float>(grid.perLine) - grid.gap;
  grid.tops.push_back(0);
  const int count = static_cast<int>(palette.size());
  for (int first = 0; first < count; first += grid.perLine) {
    size_t lines = 1;
    for (int i = first; i < std::min(count, first + grid.perLine); ++i)
      lines = std::max(lines, linesOf(palette[static_cast<size_t>(i)].name, grid.slotWidth).size());
    grid.tops.push_back(grid.tops.back() + size + static_cast<float>(lines) * ImGui::GetFontSize() + grid.lineGap);
  }
  return grid;
}

/// The one with the largest thumbnails with which all of them fit into the room; with cells of whole pixels. Where not
/// even the smallest fit with their names whole, names are shortened: a structure out of sight is worse.
ThumbnailGrid largestGrid(Ui& ui, const std::vector<Structure>& palette, ImVec2 room) {
  const float step = kCells, smallest = step * std::round(ui.px(30) / step);
  const float whole = widestHalf(palette);
  ThumbnailGrid grid = gridOf(ui, palette, smallest, whole, room.x);
  if (grid.tops.back() > room.y) grid = gridOf(ui, palette, smallest, ui.px(62), room.x);
  for (float size = smallest + step; size <= ui.px(80); size += step) {
    ThumbnailGrid larger = gridOf(ui, palette, size, whole, room.x);
    if (larger.tops.back() <= room.y) grid = std::move(larger);
  }
  return grid;
}

/// A name that has not the room is read in a tooltip. `at`: the slot.
void nameBelow(Ui& ui, const std::string& name, ImVec2 at, const ThumbnailGrid& grid) {
  ImGui::PushFont(ui.fonts.small);
  const std::vector<std::string> lines = linesOf(name, grid.slotWidth);
  ImGui::SetCursorPos(ImVec2(at.x, at.y + grid.size));
  ImGui::BeginGroup();
  for (size_t i = 0; i < lines.size(); ++i) {
    const float width = ImGui::CalcTextSize(lines[i].c_str()).x;
    ImGui::SetCursorPos(ImVec2(at.x + 0.5f * (grid.slotWidth - width),
                               at.y + grid.size + static_cast<float>(i) * ImGui::GetFontSize()));
    ImGui::TextColored(ui.theme.textQuiet, "%s", lines[i].c_str());
  }
  ImGui::EndGroup();
  ImGui::PopFont();
  const std::string id = "structure/" + name + "/name";
  ui.probe.recordItem(id);
  if (fmt::format("{}", fmt::join(lines, " ")) == name) return;
  if (ui.probe.watching()) ui.probe.fact("shortened.structure/" + name, name);
  tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), name.c_str());
}

}  // namespace

std::optional<Fabric> structurePage(Ui& ui, const Fabric& fabric, const DraftPreferences& preferences,
                                    DraftView& view) {
  std::optional<Fabric> edited;
  const float inset = ui.px(2), under = ImGui::GetFrameHeightWithSpacing() + ui.px(8);
  const ImVec2 all = ImGui::GetContentRegionAvail();
  ImGui::PushFont(ui.fonts.small);
  const ThumbnailGrid grid = largestGrid(ui, view.palette, ImVec2(all.x - inset, all.y - under));
  ImGui::PopFont();
  const ImVec2 corner(ImGui::GetCursorPosX() + inset, ImGui::GetCursorPosY() + inset);
  for (size_t i = 0; i < view.palette.size(); ++i) {
    const Structure& structure = view.palette[i];
    const ImVec2 inGrid = grid.at(static_cast<int>(i)), at(corner.x + inGrid.x, corner.y + inGrid.y);
    nameBelow(ui, structure.name, at, grid);
    ImGui::SetCursorPos(ImVec2(at.x + 0.5f * (grid.slotWidth - grid.size), at.y));
    if (structureThumbnail(ui, "structure/" + structure.name, structure, grid.size, kCells,
                           structure.weave == fabric.weave)) {
      Rewoven result = withStructure(fabric, view.selection, structure.weave, preferences.loom);
      edited = std::move(result.fabric);
      view.remark = std::move(result.remark);
      if (!view.selection) view.cell = 0;
    }
  }
  ImGui::SetCursorPos(ImVec2(corner.x - inset, corner.y + grid.tops.back()));
  ImGui::Dummy(ImVec2(0, ui.px(2)));
  const Word& library = words::draft::allStructures;
  view.libraryWanted = button(ui, "structures.open", library.label, 0, true, library.help);
  return edited;
}

}  // namespace loomlight
