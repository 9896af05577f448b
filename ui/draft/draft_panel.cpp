#include "ui/draft/draft_panel.h"

#include <algorithm>

#include "core/fabric/model/glossary.h"
#include "ui/draft/float_row.h"
#include "ui/widgets/preset_list.h"
#include "ui/words/draft_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

constexpr float kStructuresHeight = 300;  ///< at scale 1: of the structures, where panels are as wide as at first

/// How the draft is used and seen.
void panelHead(Ui& ui, DraftView& view) {
  float buttons = 0;
  for (const Word& word : {words::draft::select, words::draft::inColour, words::draft::back, words::draft::floats})
    buttons += toggleWidth(ui, word.label);
  // Where the panel is narrow they stand closer, and end where the draft does.
  const float gap = std::clamp((ImGui::GetContentRegionAvail().x - buttons) / 3, ui.px(1), ui.px(4));
  bool selects = view.tool == DraftView::Tool::select;
  const auto toggle = [&](const char* id, const Word& word, bool& on) {
    toggleButton(ui, id, word.label, word.help, on);
  };
  toggle("draft.select", words::draft::select, selects);
  view.tool = selects ? DraftView::Tool::select : DraftView::Tool::draw;
  ImGui::SameLine(0, gap);
  toggle("draft.colour", words::draft::inColour, view.inColour);
  ImGui::SameLine(0, gap);
  toggle("draft.back", words::draft::back, view.back);
  ImGui::SameLine(0, gap);
  toggle("draft.floats", words::draft::floats, view.marksFloats);
}

}  // namespace

std::optional<Fabric> draftPanel(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, int brushYarn,
                                 const LongFloats* floats, DraftPreferences& preferences, DraftView& view,
                                 std::optional<CrossingIndex> lit) {
  const ImVec2 head = ImGui::GetCursorScreenPos(), all = ImGui::GetContentRegionAvail();
  // Beside the panel: what stands below the buttons may be drawn at.
  ui.tooltipCorner = ImVec2(ImGui::GetWindowPos().x + ImGui::GetWindowWidth() + ui.px(8), head.y);
  panelHead(ui, view);
  const float buttons = ImGui::GetCursorScreenPos().y - head.y;
  if (view.marksFloats) floatRow(ui, floats, preferences, view);
  ui.tooltipCorner.reset();
  const float rows = ImGui::GetCursorScreenPos().y - head.y;
  const ImVec2 room(all.x, all.y - buttons);
  // What stands below keeps its place: tabs, a page, and the presets. In a low window the draft comes before all of
  // them; then the page, in which all structures are in sight with their names; presets have their dialog too. A row of
  // floats takes its room from the draft alone.
  const float row = ImGui::GetFrameHeightWithSpacing(), spare = room.y - ui.px(720);
  const float shared = spare > 0 ? ui.px(322) + 0.5f * spare : ui.px(202) + row;  // by page and presets
  const float wanted = std::max(ui.px(kStructuresHeight), 0.6f * shared);
  const bool listed = shared - wanted >= ui.px(kLowestPresetList);
  const float presets = listed ? shared - wanted : row, page = shared - presets;
  const float below = 2 * row + ui.px(24) + shared;
  const float height = std::max(ui.px(180), std::min(1.3f * room.x, room.y - below)) - (rows - buttons);
  std::optional<Fabric> edited =
      draftCanvas(ui, fabric, yarnColours, brushYarn, preferences, view, lit, ImVec2(room.x, height));

  static constexpr const char* kIds[] = {"draft.tab_structures", "draft.tab_loom", "draft.tab_colours"};
  static constexpr const char* kPages[] = {"structures_page", "loom_page", "colours_page"};
  int open = static_cast<int>(view.page);
  pageTabs(ui, words::panels::draftTabs, kIds, open);
  view.page = static_cast<DraftView::Page>(open);
  // Stripes have a table: there the presets are a button, as in a low window.
  const float shelf = view.page == DraftView::Page::colours ? row : presets;
  const float left = std::max(page, ImGui::GetContentRegionAvail().y - shelf);
  beginPage(ui, kPages[open], left, view.scroll);
  std::optional<Fabric> paged;
  switch (view.page) {
    case DraftView::Page::structures:
      paged = structurePage(ui, fabric, preferences, view);
      break;
    case DraftView::Page::loom:
      paged = loomPage(ui, fabric, preferences, view);
      break;
    case DraftView::Page::colours:
      paged = orderPage(ui, fabric, yarnColours, view);
      break;
  }
  endPage(view.scroll);
  return paged ? std::move(paged) : std::move(edited);
}

}  // namespace loomlight
