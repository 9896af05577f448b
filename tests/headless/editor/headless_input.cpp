#include "tests/headless/editor/headless_input.h"

#include <map>
#include <stdexcept>

namespace loomlight {
namespace {

/// A key as Dear ImGui names it, and by GLFW's number, which is all that it knows of most keys before version 1.87.
struct Key {
  ImGuiKey named;
  int glfw;
};

#if IMGUI_VERSION_NUM >= 18700
Key letter(char c) {
  return {static_cast<ImGuiKey>(ImGuiKey_A + (c - 'A')), c};
}
Key digit(char c) {
  return {static_cast<ImGuiKey>(ImGuiKey_0 + (c - '0')), c};
}
const Key kSlash{ImGuiKey_Slash, 47}, kF1{ImGuiKey_F1, 290};
#else
Key letter(char c) {
  static const std::map<char, int> named = {{'A', ImGuiKey_A}, {'C', ImGuiKey_C}, {'V', ImGuiKey_V},
                                            {'X', ImGuiKey_X}, {'Y', ImGuiKey_Y}, {'Z', ImGuiKey_Z}};
  const auto found = named.find(c);
  return {found == named.end() ? -1 : found->second, c};
}
Key digit(char c) {
  return {-1, c};
}
const Key kSlash{-1, 47}, kF1{-1, 290};
#endif

Key keyCalled(const std::string& name) {
  static const std::map<std::string, Key> keys = {
      {"Tab", {ImGuiKey_Tab, 258}},          {"Left", {ImGuiKey_LeftArrow, 263}}, {"Right", {ImGuiKey_RightArrow, 262}},
      {"Up", {ImGuiKey_UpArrow, 265}},       {"Down", {ImGuiKey_DownArrow, 264}}, {"Delete", {ImGuiKey_Delete, 261}},
      {"BackSpace", {ImGuiKey_Backspace, 259}}, {"Return", {ImGuiKey_Enter, 257}}, {"Escape", {ImGuiKey_Escape, 256}},
      {"space", {ImGuiKey_Space, 32}},       {"slash", kSlash},                   {"F1", kF1}};
  if (const auto found = keys.find(name); found != keys.end()) return found->second;
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') return letter(static_cast<char>(name[0] - 'a' + 'A'));
  if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return digit(name[0]);
  throw std::invalid_argument("no key is called " + name);
}

}  // namespace

#if IMGUI_VERSION_NUM >= 18700

HeadlessInput::HeadlessInput() = default;

void HeadlessInput::move(ImVec2 place) {
  ImGui::GetIO().AddMousePosEvent(place.x, place.y);
}

void HeadlessInput::button(int button, bool down) {
  ImGui::GetIO().AddMouseButtonEvent(button, down);
}

void HeadlessInput::wheel(float clicks) {
  ImGui::GetIO().AddMouseWheelEvent(0, clicks);
}

void HeadlessInput::key(const std::string& name, bool down) {
  ImGuiIO& io = ImGui::GetIO();
  if (name == "ctrl") return io.AddKeyEvent(ImGuiMod_Ctrl, down);
  if (name == "shift") return io.AddKeyEvent(ImGuiMod_Shift, down);
  io.AddKeyEvent(keyCalled(name).named, down);
}

#else

HeadlessInput::HeadlessInput() {
  ImGuiIO& io = ImGui::GetIO();
  for (const char* name : {"Tab", "Left", "Right", "Up", "Down", "Delete", "BackSpace", "Return", "Escape", "space",
                           "a", "c", "v", "x", "y", "z"}) {
    const Key key = keyCalled(name);
    io.KeyMap[key.named] = key.glfw;
  }
}

void HeadlessInput::move(ImVec2 place) {
  ImGui::GetIO().MousePos = place;
}

void HeadlessInput::button(int button, bool down) {
  ImGui::GetIO().MouseDown[button] = down;
}

void HeadlessInput::wheel(float clicks) {
  ImGui::GetIO().MouseWheel += clicks;
}

void HeadlessInput::key(const std::string& name, bool down) {
  ImGuiIO& io = ImGui::GetIO();
  if (name == "ctrl")
    io.KeyCtrl = down;
  else if (name == "shift")
    io.KeyShift = down;
  else
    io.KeysDown[keyCalled(name).glfw] = down;
}

#endif

void HeadlessInput::type(const std::string& utf8) {
  ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
}

}  // namespace loomlight
