#include "ui/draft/float_row.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/widgets/field_row.h"
#include "ui/words/draft_words.h"

namespace loomlight {
namespace {

void limitField(Ui& ui, double& limit_mm) {
  NumberStyle style;
  style.unit = "mm";
  style.min = 0.1;
  style.max = 100;
  style.decimals = 1;
  style.logarithmic = true;
  numberField(ui, {"draft.long_float", words::floats::limit, true}, style, limit_mm);
}

void choose(DraftView& view, const FloatRun& run) {
  view.chosenFloat = run;
  showFloat(view, run);
}

/// Which of them is looked at; none where another edit has done away with it.
int chosenAmong(const LongFloats& floats, const DraftView& view) {
  if (!view.chosenFloat) return -1;
  const auto found = std::find(floats.longest.begin(), floats.longest.end(), *view.chosenFloat);
  return found == floats.longest.end() ? -1 : static_cast<int>(found - floats.longest.begin());
}

/// What the list says while it is shut.
std::string listText(const LongFloats& floats, int chosen) {
  if (floats.count == 0) return words::floats::none;
  if (chosen >= 0) return fmt::format(words::floats::chosen, chosen + 1, floats.count);
  return floats.count == 1 ? fmt::format(words::floats::one, floats.count)
                           : fmt::format(words::floats::several, floats.count);
}

void listField(Ui& ui, const LongFloats& floats, int chosen, DraftView& view) {
  const auto listed = static_cast<int>(floats.longest.size());
  const std::string shown = listText(floats, chosen);
  ui.probe.fact("draft.floats_shown", shown);
  if (listed == 0) {  // an empty list would open
    ImGui::BeginDisabled();
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0, 0.5f));
    button(ui, "draft.float_list", shown.c_str(), ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    return;
  }
  const float room = ImGui::GetContentRegionAvail().x;
  std::string cut;
  const std::string preview = fitted(ui, "draft.float_list", shown.c_str(), room - ui.px(16), cut);
  ImGui::SetNextItemWidth(room);
  if (!ImGui::BeginCombo("##floats", preview.c_str(), ImGuiComboFlags_HeightLarge | ImGuiComboFlags_NoArrowButton)) {
    ui.probe.recordItem("draft.float_list");
    tooltipFor(ui, "draft.float_list", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), cut.c_str());
    return;
  }
  ImGuiListClipper lines;
  lines.Begin(listed);
  while (lines.Step())
    for (int i = lines.DisplayStart; i < lines.DisplayEnd; ++i) {
      ImGui::PushID(i);
      if (ImGui::Selectable(floatText(floats.longest[static_cast<size_t>(i)]).c_str(), i == chosen))
        choose(view, floats.longest[static_cast<size_t>(i)]);
      ui.probe.recordItem(fmt::format("draft.float_list/{}", i));
      ImGui::PopID();
    }
  ImGui::EndCombo();
}

}  // namespace

std::string floatText(const FloatRun& run) {
  namespace said = words::floats;
  const bool warp = run.system == System::warp;
  const int across = run.across + 1, first = run.first + 1, last = run.first + run.cells;
  if (run.isEndless)
    return warp ? fmt::format(said::endNeverInterlaces, across) : fmt::format(said::pickNeverInterlaces, across);
  const char* const side = run.onFace ? said::face : said::back;
  if (warp) {
    const std::string over =
        first == last ? fmt::format(said::overPick, first) : fmt::format(said::overPicks, first, last);
    return fmt::format(said::ofWarp, run.length_mm, side, across, over);
  }
  const std::string over = first == last ? fmt::format(said::overEnd, first) : fmt::format(said::overEnds, first, last);
  return fmt::format(said::ofWeft, run.length_mm, side, across, over);
}

void floatRow(Ui& ui, const LongFloats* floats, DraftPreferences& preferences, DraftView& view) {
  const float all = ImGui::GetContentRegionAvail().x, gap = ui.px(4), step = ui.px(28);
  const float top = ImGui::GetCursorPosY();
  ImGui::BeginChild("float_limit", ImVec2(ui.px(112), ImGui::GetFrameHeight()));
  limitField(ui, preferences.longFloat_mm);
  ImGui::EndChild();
  const LongFloats none;
  const LongFloats& known = floats ? *floats : none;
  const auto listed = static_cast<int>(known.longest.size());
  const int chosen = chosenAmong(known, view);
  if (floats && chosen < 0) view.chosenFloat.reset();  // so that nobody is told of it
  const auto go = [&](int to) { choose(view, known.longest[static_cast<size_t>((to + listed) % listed)]); };
  ImGui::SameLine(0, gap);
  if (button(ui, "draft.float_before", words::floats::before.label, step, listed > 0, words::floats::before.help))
    go(chosen < 0 ? -1 : chosen - 1);
  ImGui::SameLine(0, gap);
  if (button(ui, "draft.float_next", words::floats::next.label, step, listed > 0, words::floats::next.help))
    go(chosen + 1);
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("float_list", ImVec2(all - ui.px(112) - 2 * step - 3 * gap, ImGui::GetFrameHeight()));
  if (floats) listField(ui, known, chosen, view);
  ImGui::EndChild();
  ImGui::SetCursorPosY(top + ImGui::GetFrameHeightWithSpacing());
}

}  // namespace loomlight
