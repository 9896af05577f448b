#include "ui/draft/float_row.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

void limitField(Ui& ui, double& limit_mm) {
  NumberStyle style;
  style.unit = "mm";
  style.min = 0.1;
  style.max = 100;
  style.decimals = 1;
  style.logarithmic = true;
  numberField(
      ui,
      {"draft.long_float", "Over",
       "Floats that are longer are marked: the length that lies free between the crossings that bind it, on the "
       "face and on the back.",
       true},
      style, limit_mm);
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

void listField(Ui& ui, const LongFloats& floats, int chosen, DraftView& view) {
  const auto listed = static_cast<int>(floats.longest.size());
  const std::string shown = floats.count == 0 ? "none"
                            : chosen < 0 ? fmt::format("{} {}", floats.count, floats.count == 1 ? "float" : "floats")
                                         : fmt::format("{} of {}", chosen + 1, floats.count);
  ui.probe.fact("draft.floats_shown", shown);
  if (listed == 0) {  // an empty list would open
    ImGui::BeginDisabled();
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0, 0.5f));
    button(ui, "draft.float_list", shown.c_str(), ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    return;
  }
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (!ImGui::BeginCombo("##floats", shortened(shown, ImGui::GetContentRegionAvail().x - ui.px(16)).c_str(),
                         ImGuiComboFlags_HeightLarge | ImGuiComboFlags_NoArrowButton)) {
    ui.probe.recordItem("draft.float_list");
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
  const bool warp = run.system == System::warp;
  const char* const system = warp ? "warp" : "weft";
  const char* const name = warp ? "end" : "pick";
  if (run.isEndless) return fmt::format("{} {} never interlaces", name, run.across + 1);
  const std::string over =
      run.cells == 1 ? fmt::format("{} {}", warp ? "pick" : "end", run.first + 1)
                     : fmt::format("{} {} to {}", warp ? "picks" : "ends", run.first + 1, run.first + run.cells);
  return fmt::format("{:.1f} mm {} float, {}, {} {}, {}", run.length_mm, system, run.onFace ? "face" : "back", name,
                     run.across + 1, over);
}

void floatRow(Ui& ui, const LongFloats* floats, DraftPreferences& preferences, DraftView& view) {
  const float all = ImGui::GetContentRegionAvail().x, gap = ui.px(4), step = ui.px(28);
  const float top = ImGui::GetCursorPosY();
  ImGui::BeginChild("float limit", ImVec2(ui.px(112), ImGui::GetFrameHeight()));
  limitField(ui, preferences.longFloat_mm);
  ImGui::EndChild();
  const LongFloats none;
  const LongFloats& known = floats ? *floats : none;
  const auto listed = static_cast<int>(known.longest.size());
  const int chosen = chosenAmong(known, view);
  const auto go = [&](int to) { choose(view, known.longest[static_cast<size_t>((to + listed) % listed)]); };
  ImGui::SameLine(0, gap);
  if (button(ui, "draft.float_before", "<", step, listed > 0, "The float before")) go(chosen < 0 ? -1 : chosen - 1);
  ImGui::SameLine(0, gap);
  if (button(ui, "draft.float_next", ">", step, listed > 0, "The next float, from the longest on")) go(chosen + 1);
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("float list", ImVec2(all - ui.px(112) - 2 * step - 3 * gap, ImGui::GetFrameHeight()));
  if (floats) listField(ui, known, chosen, view);
  ImGui::EndChild();
  ImGui::SetCursorPosY(top + ImGui::GetFrameHeightWithSpacing());
}

}  // namespace loomlight
