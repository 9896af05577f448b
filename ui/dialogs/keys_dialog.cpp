#include "ui/dialogs/keys_dialog.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "ui/widgets/field_row.h"
#include "ui/widgets/modal.h"

namespace loomlight {
namespace {

struct KeyLine {
  const char* keys;
  const char* meaning;
};

constexpr KeyLine kCloth[] = {
    {"Drag", "Turn"},
    {"Shift or Space + drag", "Move, as the middle button does"},
    {"Wheel", "Nearer and further"},
    {"Click", "Choose the yarn that is there"},
    {"F or Ctrl+0, Ctrl+1", "Fit the cloth, actual size"},
    {"1, 2, 3", "From above, aslant, low"},
    {"K", "Keep this view below"},
    {"L", "Truth lens; Esc closes"},
    {"J", "The next lamp of the booth"},
    {"N", "Denoised preview"},
    {"Y, Shift+Y", "Soft proof, gamut warning"},
};
constexpr KeyLine kDraft[] = {
    {"Click, drag", "Turn crossings over"},
    {"Right drag", "Weft over"},
    {"Shift + drag", "Keep to a line"},
    {"Space + drag", "Move, as the middle button does"},
    {"Wheel", "Nearer and further"},
    {"Shift+F", "Fit the draft"},
    {"[, ], X", "Another yarn to paint with, swap"},
    {"Ctrl + drag", "Select"},
    {"Right click while selecting", "What can be done"},
    {"Ctrl+A, Ctrl+D", "Select the repeat, deselect"},
    {"Ctrl+C, Ctrl+X, Ctrl+V", "Copy, cut, paste crossings"},
    {"Ctrl+Shift+V", "Fill with the copy"},
    {"Delete, arrows, Ctrl+I", "Weft over, shift, invert"},
};
constexpr KeyLine kNumbers[] = {
    {"Drag", "Change; Shift fine, Ctrl coarse"},
    {"Click", "Type; Enter takes, Esc restores"},
    {"Tab, Shift+Tab", "The next one, the one before"},
};
constexpr KeyLine kEverywhere[] = {
    {"Ctrl+N, Ctrl+O", "New, open"},
    {"Ctrl+S, Ctrl+Shift+S", "Save, save as"},
    {"Ctrl+Z, Ctrl+Shift+Z", "Undo, redo"},
    {"Ctrl+P", "Snapshot"},
    {"Ctrl+E", "Texture tile"},
    {"Ctrl+B", "Presets, by pictures"},
    {"P, F11", "Hide panels, full screen"},
    {"F1, ?", "This list"},
    {"Ctrl+Q", "Quit"},
};

void group(Ui& ui, const char* title, std::span<const KeyLine> lines) {
  heading(ui, title);
  if (!ImGui::BeginTable(title, 2)) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, 0.46f);
  ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch, 0.54f);
  for (const KeyLine& line : lines) {
    ImGui::TableNextColumn();
    tellIfClipped(ui, "keys", line.keys, ImGui::GetContentRegionAvail().x);
    ImGui::TextDisabled("%s", line.keys);
    ImGui::TableNextColumn();
    tellIfClipped(ui, "keys", line.meaning, ImGui::GetContentRegionAvail().x);
    ImGui::TextUnformatted(line.meaning);
  }
  ImGui::EndTable();
}

}  // namespace

void KeysDialog::draw(Ui& ui) {
  if (!open_ || !beginModal(ui, "Keys and mouse", ImVec2(ui.px(1080), 0), open_, opening_)) return;
  const float row = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float height = row * static_cast<float>(std::size(kCloth) + std::size(kEverywhere)) + ui.px(88);
  ImGui::BeginChild("keys.list", ImVec2(0, std::min(height, roomAboveButtons(ui))));
  if (ImGui::BeginTable("keys", 2)) {
    ImGui::TableNextColumn();
    group(ui, "On the cloth", kCloth);
    group(ui, "Everywhere", kEverywhere);
    ImGui::TableNextColumn();
    group(ui, "In the draft", kDraft);
    group(ui, "On numbers", kNumbers);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  if (closedBelow(ui, "keys.close")) open_ = false;
  endModal();
}

}  // namespace loomlight
