#include "ui/menu_bar.h"

namespace loomlight {
namespace {

class Menu {
 public:
  explicit Menu(Ui& ui) : ui_(ui) {}

  void item(const char* id, const char* label, const char* keys, Command command, bool enabled = true,
            bool ticked = false) {
    if (ImGui::MenuItem(label, keys, ticked, enabled)) chosen_ = command;
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
  if (menu.begin("menu.file", "File")) {
    menu.item("menu.new", "New", "Ctrl+N", Command::newFabric);
    menu.item("menu.open", "Open\xE2\x80\xA6", "Ctrl+O", Command::open);
    recent = recentMenu(ui, model.recent);
    ImGui::Separator();
    menu.item("menu.save", "Save", "Ctrl+S", Command::save);
    menu.item("menu.save_as", "Save as\xE2\x80\xA6", "Ctrl+Shift+S", Command::saveAs);
    menu.item("menu.save_preset", "Keep as preset", "", Command::savePreset);
    menu.item("menu.presets", "Presets\xE2\x80\xA6", "Ctrl+B", Command::presets);
    ImGui::Separator();
    if (const auto chosen = exportMenu(ui)) draft = chosen;
    ImGui::Separator();
    menu.item("menu.snapshot", "Snapshot\xE2\x80\xA6", "Ctrl+P", Command::snapshot);
    menu.item("menu.sheet", "Cloth sheet\xE2\x80\xA6", ".pdf", Command::sheet);
    ImGui::Separator();
    menu.item("menu.quit", "Quit", "Ctrl+Q", Command::quit);
    ImGui::EndMenu();
  }
  if (menu.begin("menu.edit", "Edit")) {
    menu.item("menu.undo", "Undo", "Ctrl+Z", Command::undo, model.canUndo);
    menu.item("menu.redo", "Redo", "Ctrl+Shift+Z", Command::redo, model.canRedo);
    ImGui::Separator();
    menu.item("menu.colourways", "Colourways\xE2\x80\xA6", "", Command::colourways);
    ImGui::Separator();
    menu.item("menu.preferences", "Preferences\xE2\x80\xA6", "", Command::preferences);
    ImGui::EndMenu();
  }
  if (const auto chosen = weaveMenu(ui, model.weave)) draft = chosen;
  if (menu.begin("menu.view", "View")) {
    menu.item("menu.fit", "Fit the cloth", "Ctrl+0", Command::fitView);
    menu.item("menu.actual_size", "Actual size", "Ctrl+1", Command::actualSize);
    flat = flatMenu(ui, model.flat);
    menu.item("menu.fit_draft", "Fit the draft", "Shift+F", Command::fitDraft);
    ImGui::Separator();
    menu.item("menu.keep_view", "Keep this view", "K", Command::keepView);
    menu.item("menu.lens", "Truth lens", "L", Command::truthLens, true, model.lensOn);
    menu.item("menu.next_lamp", "Next lamp of the booth", "J", Command::boothLamp);
    menu.item("menu.denoise", "Denoised preview", "N", Command::denoise, true, model.denoised);
    ImGui::Separator();
    menu.item("menu.soft_proof", model.knowsPrinter ? "Soft proof" : "Soft proof\xE2\x80\xA6", "Y", Command::softProof,
              true, model.knowsPrinter && model.proofs);
    menu.item("menu.gamut_warning", "Gamut warning", "Shift+Y", Command::gamutWarning,
              model.knowsPrinter && model.proofs, model.warnsOfGamut);
    ImGui::Separator();
    menu.item("menu.panels", "Panels", "P", Command::togglePanels, true, model.panelsShown);
    menu.item("menu.fullscreen", "Full screen", "F11", Command::fullScreen);
    ImGui::Separator();
    menu.item("menu.dark", "Dark", "", Command::darkTheme, true, model.darkTheme);
    menu.item("menu.light", "Light", "", Command::lightTheme, true, !model.darkTheme);
    ImGui::EndMenu();
  }
  if (menu.begin("menu.help", "Help")) {
    menu.item("menu.keys", "Keys and mouse", "F1", Command::showKeys);
    menu.item("menu.about", "About Loomlight", "", Command::showAbout);
    ImGui::EndMenu();
  }
  ImGui::PopStyleVar(2);
  const std::string right = model.title + (model.edited ? "   \xE2\x97\x8F edited" : "");
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
