#include "ui/flat_menu.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/model/field_tables.h"
#include "core/fabric/yarn/derived.h"
#include "ui/draft/weave_menu.h"
#include "ui/widgets/fields.h"
#include "ui/words/menu_words.h"

namespace loomlight {
namespace {

/// Numbers that are set take effect at once.
void numbers(Ui& ui, const FlatMenuModel& model, FlatMenuChoice& choice) {
  ImGui::BeginChild("flat_numbers", ImVec2(ui.px(224), 2 * ImGui::GetFrameHeight() + ui.px(4)));
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

FlatPiece pieceOf(const Fabric& fabric, const FlatCloth& cloth) {
  const FieldInfo range = fieldInfo(&Drape::width_mm);
  FlatPiece piece;
  if (!cloth.inRepeats) {
    piece.size_mm = glm::dvec2(std::clamp(10 * cloth.count, range.min, range.max));
    return piece;
  }
  const glm::dvec2 repeat_mm(static_cast<double>(patternEnds(fabric)) * fabric.warpPitch_mm(),
                             static_cast<double>(patternPicks(fabric)) * fabric.weftPitch_mm());
  const double longer_mm = std::max(repeat_mm.x, repeat_mm.y);
  for (const int i : {0, 1}) {
    // So many repeats of stripes that go one way would be a ribbon.
    const double times = 2 * repeat_mm[i] > longer_mm ? 1 : std::round(longer_mm / repeat_mm[i]);
    piece.repeats[i] = cloth.count * times;
    piece.size_mm[i] = std::clamp(piece.repeats[i] * repeat_mm[i], range.min, range.max);
  }
  return piece;
}

std::string flatPieceText(const Fabric& fabric, const FlatCloth& cloth) {
  const FlatPiece piece = pieceOf(fabric, cloth);
  if (!cloth.inRepeats) return fmt::format("{0:g} \xC3\x97 {0:g} cm", cloth.count);
  const std::string size = fmt::format(" \xC2\xB7 {:.1f} \xC3\x97 {:.1f} mm", piece.size_mm.x, piece.size_mm.y);
  if (piece.repeats == glm::dvec2(1.0)) return words::menu::oneRepeat.label + size;
  return fmt::format("{:g} \xC3\x97 {:g} {}", piece.repeats.x, piece.repeats.y, words::menu::repeats.label) + size;
}

namespace {

/// As the menu offers it.
std::string textOf(const FlatCloth& cloth) {
  if (!cloth.inRepeats) return fmt::format("{0:g} \xC3\x97 {0:g} cm", cloth.count);
  return cloth.count == 1 ? std::string(words::menu::oneRepeat.label)
                          : fmt::format("{:g} {}", cloth.count, words::menu::repeats.label);
}

}  // namespace

FlatMenuChoice flatMenu(Ui& ui, const FlatMenuModel& model) {
  FlatMenuChoice choice;
  if (!beginMenu(ui, "menu.flat", words::menu::flatCloth.label)) return choice;
  const auto offer = [&](const char* id, const FlatCloth& cloth) {
    if (ImGui::MenuItem(textOf(cloth).c_str())) choice.cloth = cloth;
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
