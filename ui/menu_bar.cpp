#include "ui/menu_bar.h"

#include "ui/words/menu_words.h"

namespace loomlight {
namespace {

class Menu {
 public:
  explicit Menu(Ui& ui) : ui_(ui) {}

  void item(const char* id, const MenuWord& word, Command command, bool enabled = true, bool ticked = false) {
    if (ImGui::MenuItem(word.label, word.keys, ticked, enabled)) chosen_ = command;
    ui_.probe.recordItem(id);
  }
  bool begin(const char* id, const char* label) { return beginMenu(ui_, id, label); }
  std::optional<Command> chosen() const { return chosen_; }

 private:
  Ui& ui_;
  std::optional<Command> chosen_;
};

}  // namespace

MenuChoice menuBar(Ui& ui, const MenuModel& model) {
  Menu menu(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), ui.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(12), ui.px(8)));
  const bool shown = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar(2);
  if (!shown) return {};
  std::optional<DraftCommand> draft;
  RecentMenuChoice recent;
  FlatMenuChoice flat;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(16), ui.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(16), ui.px(12)));
  if (menu.begin("menu.file", words::menu::file.label)) {
    menu.item("menu.new", words::menu::newCloth, Command::newFabric);
    menu.item("menu.open", words::menu::openFile, Command::open);
    recent = recentMenu(ui, model.recent);
    ImGui::Separator();
    menu.item("menu.save", words::menu::save, Command::save);
    menu.item("menu.save_as", words::menu::saveAs, Command::saveAs);
    menu.item("menu.save_preset", words::menu::savePreset, Command::savePreset);
    menu.item("menu.presets", words::menu::presets, Command::presets);
    ImGui::Separator();
    if (const auto chosen = exportMenu(ui)) draft = chosen;
    ImGui::Separator();
    menu.item("menu.snapshot", words::menu::snapshot, Command::snapshot);
    menu.item("menu.sheet", words::menu::sheet, Command::sheet);
    ImGui::Separator();
    menu.item("menu.quit", words::menu::quit, Command::quit);
    ImGui::EndMenu();
  }
  if (menu.begin("menu.edit", words::menu::edit.label)) {
    menu.item("menu.undo", words::menu::undo, Command::undo, model.canUndo);
    menu.item("menu.redo", words::menu::redo, Command::redo, model.canRedo);
    ImGui::Separator();
    menu.item("menu.colourways", words::menu::colourways, Command::colourways);
    ImGui::Separator();
    menu.item("menu.preferences", words::menu::preferences, Command::preferences);
    ImGui::EndMenu();
  }
  if (const auto chosen = weaveMenu(ui, model.weave)) draft = chosen;
  if (menu.begin("menu.view", words::menu::view.label)) {
    menu.item("menu.fit", words::menu::fit, Command::fitView);
    menu.item("menu.actual_size", words::menu::actualSize, Command::actualSize);
    flat = flatMenu(ui, model.flat);
    menu.item("menu.fit_draft", words::menu::fitDraft, Command::fitDraft);
    ImGui::Separator();
    menu.item("menu.keep_view", words::menu::keepView, Command::keepView);
    menu.item("menu.lens", words::menu::truthLens, Command::truthLens, true, model.insetOn);
    menu.item("menu.next_lamp", words::menu::nextLamp, Command::boothLamp);
    menu.item("menu.denoise", words::menu::denoise, Command::denoise, true, model.denoised);
    ImGui::Separator();
    menu.item("menu.soft_proof", model.knowsPrinter ? words::menu::softProof : words::menu::chooseProof,
              Command::softProof, true, model.knowsPrinter && model.proofs);
    menu.item("menu.gamut_warning", words::menu::gamutWarning, Command::gamutWarning,
              model.knowsPrinter && model.proofs, model.warnsOfGamut);
    ImGui::Separator();
    menu.item("menu.panels", words::menu::panels, Command::togglePanels, true, model.panelsShown);
    menu.item("menu.fullscreen", words::menu::fullscreen, Command::fullScreen);
    ImGui::Separator();
    menu.item("menu.dark", words::menu::darkTheme, Command::darkTheme, true, model.darkTheme);
    menu.item("menu.light", words::menu::lightTheme, Command::lightTheme, true, !model.darkTheme);
    ImGui::EndMenu();
  }
  if (menu.begin("menu.help", words::menu::help.label)) {
    menu.item("menu.keys", words::menu::keysAndMouse, Command::showKeys);
    menu.item("menu.about", words::menu::about, Command::showAbout);
    ImGui::EndMenu();
  }
  ImGui::PopStyleVar(2);
  const std::string right = model.title + (model.edited ? words::menu::edited.label : "");
  const ImVec2 size = ImGui::CalcTextSize(right.c_str());
  const ImVec2 bar = ImGui::GetWindowPos();
  const ImVec2 at(bar.x + ImGui::GetWindowWidth() - size.x - ui.px(16),
                  bar.y + 0.5f * (ImGui::GetWindowHeight() - size.y));
  ImGui::GetWindowDrawList()->AddText(at, packed(ui.theme.text), right.c_str());
  ui.probe.record("title", at, ImVec2(at.x + size.x, at.y + size.y));
  ImGui::EndMainMenuBar();
  return {menu.chosen(), draft, recent, flat};
}

}  // namespace loomlight
