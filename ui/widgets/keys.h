#pragma once

#include <imgui.h>

#include <utility>

namespace loomlight {

// Which keys are pressed in this frame. Dear ImGui 1.87 gave every key a name and took away the numbers by which 1.86
// (Debian 12) knows them. Panels, the window and tests ask this file
// alone, so that they need not know which of the two it is.
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

/// Whether Dear ImGui's backend asks which letter the keyboard's layout has on a key; else its window has to.
inline constexpr bool kAsksForTheLayout = IMGUI_VERSION_NUM >= 18700;

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

/// The item that follows takes the keyboard.
void focusNextItem();

// What a window's backend says of the keyboard; for those that have no window.

/// Before the first frame. Letters that Dear ImGui has names for too have one number by both.
inline void nameKeys([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
  constexpr int kFree = 400;
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = kFree + key;
  for (const auto& [key, letter] : {std::pair(ImGuiKey_A, 'A'), std::pair(ImGuiKey_C, 'C'), std::pair(ImGuiKey_V, 'V'),
                                    std::pair(ImGuiKey_X, 'X'), std::pair(ImGuiKey_Y, 'Y'), std::pair(ImGuiKey_Z, 'Z')})
    io.KeyMap[key] = numberOfLetter(letter);
#endif
}
/// By its number.
inline void holdNumbered(ImGuiIO& io, decltype(numberOfLetter('A')) key, bool held) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(key, held);
#else
  io.KeysDown[key] = held;
#endif
}
inline void holdKey(ImGuiIO& io, ImGuiKey key, bool held) {
  holdNumbered(io, numberOfKey(key), held);
}
inline void holdLetter(ImGuiIO& io, char letter, bool held) {
  holdNumbered(io, numberOfLetter(letter), held);
}
inline void holdControl(ImGuiIO& io, bool held) {
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Ctrl, held);
#else
  io.KeyCtrl = held;
#endif
}
inline void holdShift(ImGuiIO& io, bool held) {
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Shift, held);
#else
  io.KeyShift = held;
#endif
}

}  // namespace loomlight
