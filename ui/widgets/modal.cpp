#include "ui/widgets/modal.h"

#include <imgui_internal.h>

#include <utility>

#include "ui/widgets/fields.h"
#include "ui/widgets/keys.h"
#include "ui/words/common_words.h"

namespace loomlight {
namespace {

constexpr float kEdge = 24;        // from the window's
constexpr float kLowestRows = 56;  // of those that scroll: a row, and that there are more of them
constexpr int kSettles = 3;        // frames until a dialog that is as high as its rows knows how high they are

}  // namespace

bool beginModal(Ui& ui, const char* title, ImVec2 size, bool& open, bool& opening) {
  const bool opensNow = std::exchange(opening, false);  // the key that brings a dialog up must not answer it
  if (opensNow) {
    ImGui::OpenPopup(title);
    ui.memory.dialogOpened = ImGui::GetFrameCount();
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float edge = ui.px(kEdge);
  size.x = std::min(size.x, screen.x - 2 * edge);
  if (size.y > 0) size.y = std::min(size.y, screen.y - 2 * edge);
  // In the middle when it appears; rows that come and go later move no other, as long as the window has the room.
  const ImGuiWindow* const before = ImGui::FindWindowByName(title);
  const ImVec2 last = ui.memory.screen;
  const bool resized = last.x != screen.x || last.y != screen.y;
  const bool leaves = before && before->Active && before->Pos.y + before->Size.y > screen.y - ui.px(4);
  const bool settles = ImGui::GetFrameCount() - ui.memory.dialogOpened <= kSettles;
  ui.memory.screen = screen;
  if (settles) ui.wakeWithin(0);
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y),
                          resized || leaves || settles ? ImGuiCond_Always : ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(size, ImGuiCond_Always);
  open = ImGui::BeginPopupModal(title, nullptr,
                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings);
  if (!open) return false;
  const ImVec2 corner = ImGui::GetWindowPos(), whole = ImGui::GetWindowSize();
  ui.probe.record("modal", corner, ImVec2(corner.x + whole.x, corner.y + whole.y));
  // As it is before the fields answer to the keys of this frame.
  const bool isTyping = ui.memory.typing != 0;
  ui.memory.keysAreTaken = isTyping || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId) || opensNow;
  const std::string text(title);
  heading(ui, text.substr(0, text.find("##")).c_str());
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  return true;
}

bool beginLastingModal(Ui& ui, const char* title, ImVec2 size, bool& open, bool& opening) {
  if (beginModal(ui, title, size, open, opening)) return true;
  open = opening = true;
  ui.wakeWithin(0);
  return false;
}

void endModal() {
  ImGui::EndPopup();
}

float roomAboveButtons(const Ui& ui) {
  const float below = ui.px(16) + ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().WindowPadding.y;
  return std::max(ui.px(96), ImGui::GetIO().DisplaySize.y - 2 * ui.px(kEdge) - ImGui::GetCursorPosY() - below);
}

void beginModalRows(const Ui& ui, const char* id, float below) {
  const float room = std::max(ui.px(kLowestRows), roomAboveButtons(ui) - below);
  const float known = ImGui::GetStateStorage()->GetFloat(ImGui::GetID(id), room);
  ImGui::BeginChild(id, ImVec2(0, std::min(known, room)));
}

void endModalRows(const char* id) {
  const float height = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
  ImGui::EndChild();
  ImGui::GetStateStorage()->SetFloat(ImGui::GetID(id), height);
}

bool modalCancelled(const Ui& ui) {
  return keyPressed(ImGuiKey_Escape) && !ui.memory.keysAreTaken;
}

bool modalConfirmed(const Ui& ui) {
  const bool enter = keyPressed(ImGuiKey_Enter) || keyPressed(kKeypadEnter);
  return enter && !ui.memory.keysAreTaken && !ImGui::GetIO().WantTextInput;
}

void closeModal(bool& open) {
  open = false;
  ImGui::CloseCurrentPopup();
}

void closeButtonBelow(Ui& ui, const char* id, bool& open) {
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ui.px(136));
  if (button(ui, id, words::common::close, ui.px(120)) || modalCancelled(ui) || modalConfirmed(ui)) closeModal(open);
}

}  // namespace loomlight
