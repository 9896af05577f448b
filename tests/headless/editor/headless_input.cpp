#include "tests/headless/editor/headless_input.h"

#include <map>
#include <stdexcept>

#include "ui/widgets/keys.h"

namespace loomlight {

HeadlessInput::HeadlessInput() {
  nameKeys(ImGui::GetIO());
}

void HeadlessInput::move(ImVec2 place) {
  ImGui::GetIO().MousePos = place;
}

void HeadlessInput::button(int button, bool down) {
  if (down) actions_.button();
  ImGui::GetIO().MouseDown[button] = down;
}

void HeadlessInput::wheel(float clicks) {
  actions_.wheel();
  ImGui::GetIO().MouseWheel += clicks;
}

void HeadlessInput::key(const std::string& name, bool down) {
  static const std::map<std::string, ImGuiKey> named = {
      {"Tab", ImGuiKey_Tab},      {"Left", ImGuiKey_LeftArrow}, {"Right", ImGuiKey_RightArrow},
      {"Up", ImGuiKey_UpArrow},   {"Down", ImGuiKey_DownArrow}, {"Delete", ImGuiKey_Delete},
      {"Return", ImGuiKey_Enter}, {"Escape", ImGuiKey_Escape},  {"space", ImGuiKey_Space}};
  if (down) actions_.key(name);
  ImGuiIO& io = ImGui::GetIO();
  if (name == "ctrl") return holdControl(io, down);
  if (name == "shift") return holdShift(io, down);
  if (name == "F1") return holdNumbered(io, numberOfFunctionKey(1), down);
  if (const auto found = named.find(name); found != named.end()) return holdKey(io, found->second, down);
  const char c = name.size() == 1 ? name[0] : ' ';
  if (c >= 'a' && c <= 'z') return holdLetter(io, static_cast<char>(c - 'a' + 'A'), down);
  if (c >= '0' && c <= '9') return holdLetter(io, c, down);
  throw std::invalid_argument("no key is called " + name);
}

void HeadlessInput::character(const std::string& utf8) {
  actions_.key(utf8);
  ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
}

void HeadlessInput::type(const std::string& utf8) {
  actions_.typed();
  ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
}

}  // namespace loomlight
