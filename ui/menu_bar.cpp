#include "ui/menu_bar.h"

#include "ui/widgets/field_row.h"
#include "ui/widgets/fields.h"
#include "ui/words/menu_words.h"

namespace loomlight {
namespace {

/// The menus of the bar, one function each; what is chosen in any of them is gathered.
class Menus {
 public:
  Menus(Ui& ui, const MenuModel& model) : ui_(ui), model_(model) {}

  MenuChoice draw() {
    file();
    edit();
    if (const auto chosen = weaveMenu(ui_, model_.weave)) choice_.draft = chosen;
    view();
    help();
    return choice_;
  }

 private:
  void item(const char* id, const MenuWord& word, Command command, bool enabled = true, bool ticked = false) {
    if (ImGui::MenuItem(word.label, word.keys, ticked, enabled)) choice_.command = command;
    ui_.probe.recordItem(id);
    ui_.probe.fact(id, ticked ? "ticked" : "");
    tooltipFor(ui_, id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), word.help);
  }

  void file() {
    if (!beginMenu(ui_, "menu.file", words::menu::file.label)) return;
    item("menu.new", words::menu::newCloth, Command::newFabric);
    item("menu.open", words::menu::openFile, Command::open);
    choice_.recent = recentMenu(ui_, model_.recent);
    ImGui::Separator();
    item("menu.save", words::menu::save, Command::save);
    item("menu.save_as", words::menu::saveAs, Command::saveAs);
    item("menu.save_preset", words::menu::savePreset, Command::savePreset);
    item("menu.presets", words::menu::presets, Command::presets);
    ImGui::Separator();
    if (const auto chosen = exportMenu(ui_)) choice_.draft = chosen;
    ImGui::Separator();
    item("menu.snapshot", words::menu::snapshot, Command::snapshot);
    item("menu.sheet", words::menu::sheet, Command::sheet);
    item("menu.handover", words::menu::handover, Command::handover);
    ImGui::Separator();
    item("menu.quit", words::menu::quit, Command::quit);
    ImGui::EndMenu();
  }

  void edit() {
    if (!beginMenu(ui_, "menu.edit", words::menu::edit.label)) return;
    item("menu.undo", words::menu::undo, Command::undo, model_.canUndo);
    item("menu.redo", words::menu::redo, Command::redo, model_.canRedo);
    ImGui::Separator();
    item("menu.colourways", words::menu::colourways, Command::colourways);
    ImGui::Separator();
    item("menu.preferences", words::menu::preferences, Command::preferences);
    ImGui::EndMenu();
  }

  void view() {
    if (!beginMenu(ui_, "menu.view", words::menu::view.label)) return;
    item("menu.fit", words::menu::fit, Command::fitView);
    item("menu.actual_size", words::menu::actualSize, Command::actualSize);
    choice_.flat = flatMenu(ui_, model_.flat);
    item("menu.fit_draft", words::menu::fitDraft, Command::fitDraft);
    ImGui::Separator();
    item("menu.keep_view", words::menu::keepView, Command::keepView);
    item("menu.lens", words::menu::truthLens, Command::truthLens, true, model_.insetOn);
    item("menu.next_lamp", words::menu::nextLamp, Command::boothLamp);
    item("menu.booth", words::menu::boothSideBySide, Command::boothSideBySide, true, model_.boothSideBySide);
    item("menu.colour_difference", words::menu::colourDifference, Command::colourDifference);
    item("menu.plain_tone", words::menu::plainTone, Command::plainTone, !model_.judgesColour, model_.plainTone);
    item("menu.denoise", words::menu::denoise, Command::denoise, true, model_.denoised);
    ImGui::Separator();
    item("menu.soft_proof", model_.knowsPrinter ? words::menu::softProof : words::menu::chooseProof, Command::softProof,
         true, model_.knowsPrinter && model_.proofs);
    item("menu.gamut_warning", words::menu::gamutWarning, Command::gamutWarning, true, model_.warnsOfGamut);
    ImGui::Separator();
    item("menu.panels", words::menu::panels, Command::togglePanels, true, model_.panelsShown);
    item("menu.fullscreen", words::menu::fullscreen, Command::fullScreen);
    ImGui::Separator();
    item("menu.dark", words::menu::darkTheme, Command::darkTheme, true, model_.darkTheme);
    item("menu.light", words::menu::lightTheme, Command::lightTheme, true, !model_.darkTheme);
    ImGui::EndMenu();
  }

  void help() {
    if (!beginMenu(ui_, "menu.help", words::menu::help.label)) return;
    item("menu.keys", words::menu::keysAndMouse, Command::showKeys);
    item("menu.about", words::menu::about, Command::showAbout);
    ImGui::EndMenu();
  }

  Ui& ui_;
  const MenuModel& model_;
  MenuChoice choice_;
};

/// The cloth's name, at the right end of the bar.
void title(Ui& ui, const MenuModel& model) {
  const char* const edited = model.edited ? words::menu::edited.label : "";
  const float room = ImGui::GetContentRegionAvail().x - ui.px(32) - ImGui::CalcTextSize(edited).x;
  std::string cut;
  const std::string right = fitted(ui, "title", model.title.c_str(), room, cut) + edited;
  const ImVec2 size = ImGui::CalcTextSize(right.c_str());
  const ImVec2 bar = ImGui::GetWindowPos();
  const ImVec2 at(bar.x + ImGui::GetWindowWidth() - size.x - ui.px(16),
                  bar.y + 0.5f * (ImGui::GetWindowHeight() - size.y));
  ImGui::GetWindowDrawList()->AddText(at, packed(ui.theme.text), right.c_str());
  const ImVec2 far(at.x + size.x, at.y + size.y);
  ui.probe.record("title", at, far);
  tooltipFor(ui, "title", at, far, cut.c_str());
}

}  // namespace

MenuChoice menuBar(Ui& ui, const MenuModel& model) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), ui.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(12), ui.px(8)));
  const bool shown = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar(2);
  if (!shown) return {};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(16), ui.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(16), ui.px(12)));
  const MenuChoice choice = Menus(ui, model).draw();
  ImGui::PopStyleVar(2);
  title(ui, model);
  ImGui::EndMainMenuBar();
  return choice;
}

}  // namespace loomlight
