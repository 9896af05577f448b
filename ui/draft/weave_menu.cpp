#include "ui/draft/weave_menu.h"

#include "ui/widgets/keys.h"
#include "ui/words/menu_words.h"

namespace loomlight {
namespace {

constexpr const char* kSelectionMenu = "selection_menu";

class Items {
 public:
  explicit Items(Ui& ui) : ui_(ui) {}
  void add(const char* id, const MenuWord& word, DraftCommand command, bool enabled = true, bool ticked = false) {
    if (ImGui::MenuItem(word.label, word.keys, ticked, enabled)) chosen_ = command;
    ui_.probe.recordItem(id);
  }
  std::optional<DraftCommand> chosen() const { return chosen_; }

 private:
  Ui& ui_;
  std::optional<DraftCommand> chosen_;
};

/// What is done to the selection, or to the whole repeat.
void editItems(Ui& ui, Items& items, bool selection) {
  items.add("menu.select_all", words::menu::selectAll, DraftCommand::selectAll);
  items.add("menu.select_nothing", words::menu::selectNothing, DraftCommand::selectNothing, selection);
  items.add("menu.cut", words::menu::cut, DraftCommand::cut);
  items.add("menu.copy", words::menu::copy, DraftCommand::copy);
  items.add("menu.paste", words::menu::paste, DraftCommand::paste);
  items.add("menu.fill", words::menu::fillWithCopy, DraftCommand::fillWithCopy);
  items.add("menu.clear", words::menu::weftOver, DraftCommand::clear, selection);
  ImGui::Separator();
  items.add("menu.invert", words::menu::invert, DraftCommand::invert);
  items.add("menu.mirror_ends", words::menu::mirrorEnds, DraftCommand::mirrorEnds);
  items.add("menu.mirror_picks", words::menu::mirrorPicks, DraftCommand::mirrorPicks);
  items.add("menu.turn", words::menu::rotate, DraftCommand::quarterTurn);
  if (beginMenu(ui, "menu.shift", words::menu::shift.label)) {
    items.add("menu.shift_left", words::menu::shiftLeft, DraftCommand::shiftLeft);
    items.add("menu.shift_right", words::menu::shiftRight, DraftCommand::shiftRight);
    items.add("menu.shift_up", words::menu::shiftUp, DraftCommand::shiftUp);
    items.add("menu.shift_down", words::menu::shiftDown, DraftCommand::shiftDown);
    ImGui::EndMenu();
  }
  items.add("menu.crop", words::menu::cropToSelection, DraftCommand::repeatSelection, selection);
}

}  // namespace

bool beginMenu(Ui& ui, const char* id, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  if (!open) ui.probe.recordItem(id);
  if (!open || !keyPressed(ImGuiKey_Escape)) return open;
  // A list within it under the mouse would open once more, and stay open without being seen.
  ImGui::CloseCurrentPopup();
  ImGui::EndMenu();
  return false;
}

std::optional<DraftCommand> weaveMenu(Ui& ui, const WeaveMenuModel& model) {
  if (!beginMenu(ui, "menu.weave", words::menu::weave.label)) return std::nullopt;
  Items items(ui);
  items.add("menu.structures", words::menu::structures, DraftCommand::structures);
  items.add("menu.picture", words::menu::fromPicture, DraftCommand::fromPicture);
  ImGui::Separator();
  editItems(ui, items, model.selection);
  ImGui::Separator();
  items.add("menu.back", words::menu::backOfCloth, DraftCommand::showBack, true, model.back);
  items.add("menu.floats", words::menu::checkFloats, DraftCommand::markFloats, true, model.marksFloats);
  ImGui::EndMenu();
  return items.chosen();
}

void openSelectionMenu() {
  ImGui::OpenPopup(kSelectionMenu);
}

std::optional<DraftCommand> selectionMenu(Ui& ui, bool selection) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(16), ui.px(10)));
  Items items(ui);
  if (ImGui::BeginPopup(kSelectionMenu)) {
    editItems(ui, items, selection);
    if (keyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return items.chosen();
}

std::optional<DraftCommand> exportMenu(Ui& ui) {
  if (!beginMenu(ui, "menu.export", words::menu::exportTo.label)) return std::nullopt;
  Items items(ui);
  items.add("menu.export_wif", words::menu::exportWif, DraftCommand::exportWif);
  items.add("menu.export_bitmap", words::menu::exportBitmap, DraftCommand::exportBitmap);
  items.add("menu.export_draft", words::menu::exportDraft, DraftCommand::exportDraft);
  items.add("menu.export_tile", words::menu::exportTile, DraftCommand::exportTile);
  ImGui::EndMenu();
  return items.chosen();
}

}  // namespace loomlight
