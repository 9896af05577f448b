#include "ui/flat_menu.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/model/field_tables.h"
#include "core/fabric/yarn/derived.h"
#include "ui/draft/weave_menu.h"
#include "ui/widgets/fields.h"
#include "ui/words/menu_words.h"

namespace loomlight {
namespace {

/// Numbers that are set take effect at once.
void numbers(Ui& ui, const FlatMenuModel& model, FlatMenuChoice& choice) {
  ImGui::BeginChild("flat numbers", ImVec2(ui.px(224), 2 * ImGui::GetFrameHeight() + ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(4)));
  int repeats = model.repeats;
  if (wholeNumberField(ui, {"menu.flat_count", words::menu::flatCount.label, words::menu::flatCount.help}, "", 1, 100,
                       repeats))
    choice.cloth = FlatCloth{true, static_cast<double>(repeats)};
  NumberStyle style;
  style.unit = "cm";
  style.min = 0.1;
  style.max = 200;
  style.decimals = 1;
  style.logarithmic = true;
  double side_cm = model.side_cm;
  if (numberField(ui, {"menu.flat_side", words::menu::flatSide.label, words::menu::flatSide.help}, style, side_cm))
    choice.cloth = FlatCloth{false, side_cm};
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

}  // namespace

glm::dvec2 pieceOf_mm(const Fabric& fabric, const FlatCloth& cloth) {
  const FieldInfo range = fieldInfo(&Drape::width_mm);
  const auto length = [&](int64_t threads, double pitch_mm) {
    const double mm = cloth.inRepeats ? cloth.count * static_cast<double>(threads) * pitch_mm : 10 * cloth.count;
    return std::clamp(mm, range.min, range.max);
  };
  return {length(patternEnds(fabric), fabric.warpPitch_mm()), length(patternPicks(fabric), fabric.weftPitch_mm())};
}

std::string flatClothText(const FlatCloth& cloth) {
  if (cloth.inRepeats && cloth.count == 1) return words::menu::oneRepeat.label;
  return fmt::format("{0:g} \xC3\x97 {0:g} {1}", cloth.count, cloth.inRepeats ? words::menu::repeats.label : "cm");
}

FlatMenuChoice flatMenu(Ui& ui, const FlatMenuModel& model) {
  FlatMenuChoice choice;
  if (!beginMenu(ui, "menu.flat", words::menu::flatCloth.label)) return choice;
  const auto offer = [&](const char* id, const FlatCloth& cloth) {
    if (ImGui::MenuItem(flatClothText(cloth).c_str())) choice.cloth = cloth;
    ui.probe.recordItem(id);
  };
  offer("menu.flat_repeat", {true, 1});
  offer("menu.flat_repeats", {true, static_cast<double>(model.repeats)});
  offer("menu.flat_cm", {false, model.side_cm});
  ImGui::Separator();
  numbers(ui, model, choice);
  ImGui::Separator();
  choice.asDraped = ImGui::MenuItem(words::menu::asDraped.label, words::menu::asDraped.keys, false, model.isFlat);
  ui.probe.recordItem("menu.as_draped");
  ImGui::EndMenu();
  return choice;
}

}  // namespace loomlight
