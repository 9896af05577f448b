#pragma once

#include <imgui.h>

namespace loomlight {

// Which keys are pressed in this frame. Dear ImGui 1.87 (Debian 13) gave every key a name and took away the numbers by
// which 1.86 (Debian 12) knows them; only this file knows of both.
#if IMGUI_VERSION_NUM >= 18700
inline constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeypadEnter;
inline ImGuiKey numberOfKey(ImGuiKey key) {
  return key;
}
inline ImGuiKey numberOfLetter(char letter) {
  return static_cast<ImGuiKey>(letter <= '9' ? ImGuiKey_0 + (letter - '0') : ImGuiKey_A + (letter - 'A'));
}
inline ImGuiKey numberOfFunctionKey(int n) {
  return static_cast<ImGuiKey>(ImGuiKey_F1 + (n - 1));
}
#else
inline constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeyPadEnter;
inline int numberOfKey(ImGuiKey key) {
  return ImGui::GetKeyIndex(key);
}
inline int numberOfLetter(char letter) {
  return letter;
}
inline int numberOfFunctionKey(int n) {
  return 289 + n;  // as GLFW, whose numbers its backend hands on
}
#endif

/// A key such as ImGuiKey_Escape went down; with `repeat` also again and again while it is held.
inline bool keyPressed(ImGuiKey key, bool repeat = false) {
  return ImGui::IsKeyPressed(numberOfKey(key), repeat);
}
inline bool keyHeld(ImGuiKey key) {
  return ImGui::IsKeyDown(numberOfKey(key));
}
/// The key with this letter, 'A' to 'Z', or digit, '0' to '9', went down.
inline bool letterPressed(char letter) {
  return ImGui::IsKeyPressed(numberOfLetter(letter), false);
}
/// F1 to F12 went down.
inline bool functionKeyPressed(int n) {
  return ImGui::IsKeyPressed(numberOfFunctionKey(n), false);
}

/// What a window's backend says of the keyboard; for those that have no window.
inline void holdLetter(ImGuiIO& io, char letter, bool held) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(numberOfLetter(letter), held);
#else
  io.KeysDown[numberOfLetter(letter)] = held;
#endif
}
inline void holdControl(ImGuiIO& io, bool held) {
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Ctrl, held);
#else
  io.KeyCtrl = held;
#endif
}

}  // namespace loomlight
