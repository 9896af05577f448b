#include "ui/draft/weave_menu.h"

#include "core/fabric/model/glossary.h"
#include "ui/widgets/keys.h"

namespace loomlight {
namespace {

constexpr const char* kSelectionMenu = "selection menu";

class Items {
 public:
  explicit Items(Ui& ui) : ui_(ui) {}
  void add(const char* id, const char* label, const char* keys, DraftCommand command, bool enabled = true,
           bool ticked = false) {
    if (ImGui::MenuItem(label, keys, ticked, enabled)) chosen_ = command;
    ui_.probe.recordItem(id);
  }
  std::optional<DraftCommand> chosen() const { return chosen_; }

 private:
  Ui& ui_;
  std::optional<DraftCommand> chosen_;
};

/// What is done to the selection, or to the whole repeat.
void editItems(Ui& ui, Items& items, bool selection) {
  items.add("menu.select_all", "Select all", "Ctrl+A", DraftCommand::selectAll);
  items.add("menu.select_nothing", "Deselect", "Esc", DraftCommand::selectNothing, selection);
  items.add("menu.cut", "Cut", "Ctrl+X", DraftCommand::cut);
  items.add("menu.copy", "Copy", "Ctrl+C", DraftCommand::copy);
  items.add("menu.paste", "Paste", "Ctrl+V", DraftCommand::paste);
  items.add("menu.fill", "Fill with the copy", "Ctrl+Shift+V", DraftCommand::fillWithCopy);
  items.add("menu.clear", "Weft over", "Delete", DraftCommand::clear, selection);
  ImGui::Separator();
  items.add("menu.invert", "Invert", "Ctrl+I", DraftCommand::invert);
  items.add("menu.mirror_ends", words::mirrorWarp.label, "", DraftCommand::mirrorEnds);
  items.add("menu.mirror_picks", words::mirrorWeft.label, "", DraftCommand::mirrorPicks);
  items.add("menu.turn", words::rotate.label, "", DraftCommand::quarterTurn);
  if (beginMenu(ui, "menu.shift", "Shift")) {
    items.add("menu.shift_left", "Left", "Left", DraftCommand::shiftLeft);
    items.add("menu.shift_right", "Right", "Right", DraftCommand::shiftRight);
    items.add("menu.shift_up", "Up", "Up", DraftCommand::shiftUp);
    items.add("menu.shift_down", "Down", "Down", DraftCommand::shiftDown);
    ImGui::EndMenu();
  }
  items.add("menu.crop", "Crop the repeat to the selection", "", DraftCommand::repeatSelection, selection);
}

}  // namespace

bool beginMenu(Ui& ui, const char* id, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  if (!open) ui.probe.recordItem(id);
  if (open && keyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  return open;
}

std::optional<DraftCommand> weaveMenu(Ui& ui, const WeaveMenuModel& model) {
  if (!beginMenu(ui, "menu.weave", "Weave")) return std::nullopt;
  Items items(ui);
  items.add("menu.structures", "Structures\xE2\x80\xA6", "", DraftCommand::structures);
  items.add("menu.picture", "From a picture\xE2\x80\xA6", "", DraftCommand::fromPicture);
  ImGui::Separator();
  editItems(ui, items, model.selection);
  ImGui::Separator();
  items.add("menu.back", words::backOfCloth.label, "", DraftCommand::showBack, true, model.back);
  items.add("menu.floats", words::checkFloats.label, "", DraftCommand::markFloats, true, model.marksFloats);
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
  if (!beginMenu(ui, "menu.export", "Export")) return std::nullopt;
  Items items(ui);
  items.add("menu.export_wif", "WIF draft\xE2\x80\xA6", ".wif", DraftCommand::exportWif);
  items.add("menu.export_bitmap", "Weave bitmap\xE2\x80\xA6", ".png, .tif", DraftCommand::exportBitmap);
  items.add("menu.export_draft", "Printed draft\xE2\x80\xA6", ".pdf .png", DraftCommand::exportDraft);
  items.add("menu.export_tile", "Texture tile\xE2\x80\xA6", ".exr .png", DraftCommand::exportTile);
  ImGui::EndMenu();
  return items.chosen();
}

}  // namespace loomlight
