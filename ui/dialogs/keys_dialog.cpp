#include "ui/dialogs/keys_dialog.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "ui/widgets/field_row.h"
#include "ui/widgets/modal.h"
#include "ui/words/key_words.h"
#include "ui/words/menu_words.h"

namespace loomlight {
namespace {

void group(Ui& ui, const char* title, std::span<const words::KeyLine> lines) {
  heading(ui, title);
  if (!ImGui::BeginTable(title, 2)) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, 0.46f);
  ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch, 0.54f);
  for (const words::KeyLine& line : lines) {
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
  if (!open_ || !beginModal(ui, words::menu::keysAndMouse.label, ImVec2(ui.px(1080), 0), open_, opening_)) return;
  const float row = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float height =
      row * static_cast<float>(std::size(words::keys::onTheCloth) + std::size(words::keys::everywhere)) + ui.px(88);
  ImGui::BeginChild("keys.list", ImVec2(0, std::min(height, roomAboveButtons(ui))));
  if (ImGui::BeginTable("keys", 2)) {
    ImGui::TableNextColumn();
    group(ui, words::keys::clothTitle, words::keys::onTheCloth);
    group(ui, words::keys::everywhereTitle, words::keys::everywhere);
    ImGui::TableNextColumn();
    group(ui, words::keys::draftTitle, words::keys::inTheDraft);
    group(ui, words::keys::numbersTitle, words::keys::onNumbers);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  closeButtonBelow(ui, "keys.close", open_);
  endModal();
}

}  // namespace loomlight
