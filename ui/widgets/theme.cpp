#include "ui/widgets/theme.h"

namespace loomlight {
namespace {

ImVec4 hex(unsigned rgb) {
  return ImVec4(static_cast<float>(rgb >> 16 & 255) / 255.0f, static_cast<float>(rgb >> 8 & 255) / 255.0f,
                static_cast<float>(rgb & 255) / 255.0f, 1.0f);
}

ImVec4 faded(ImVec4 colour, float opacity) {
  colour.w *= opacity;
  return colour;
}

/// 18 % linear reflectance, sRGB-encoded.
constexpr unsigned kMiddleGrey = 0x767676;

}  // namespace

Theme Theme::dark() {
  Theme t;
  t.window = hex(0x161617);
  t.panel = hex(0x212122);
  t.field = hex(0x2e2e30);
  t.fieldHover = hex(0x38383b);
  t.fieldFill = hex(0x434347);
  t.line = hex(0x363638);
  t.text = hex(0xe4e4e5);
  t.textQuiet = hex(0xb0b0b4);
  t.accent = hex(0x8fb4d6);
  t.onAccent = hex(0x10161b);
  t.warning = hex(0xe0ac4c);
  t.error = hex(0xe57f74);
  t.popup = hex(0x212122);
  t.paper = hex(0xd9d9d7);
  t.ink = hex(0x1b1b1c);
  t.surround = hex(kMiddleGrey);
  return t;
}

Theme Theme::light() {
  Theme t;
  t.window = hex(0xc9c9ca);
  t.panel = hex(0xe9e9ea);
  t.field = hex(0xf8f8f8);
  t.fieldHover = hex(0xffffff);
  t.fieldFill = hex(0xd8d9db);
  t.line = hex(0xcfcfd1);
  t.text = hex(0x1d1d1f);
  t.textQuiet = hex(0x5d5d61);
  t.accent = hex(0x2c6391);
  t.onAccent = hex(0xffffff);
  t.warning = hex(0x8f5d00);
  t.error = hex(0xb3352a);
  t.popup = hex(0xe9e9ea);
  t.paper = hex(0xffffff);
  t.ink = hex(0x2a2a2b);
  t.surround = hex(kMiddleGrey);
  return t;
}

void Theme::apply(ImGuiStyle& style, float scale) const {
  style = ImGuiStyle();
  style.WindowPadding = ImVec2(16, 16);
  style.FramePadding = ImVec2(8, 4);
  style.ItemSpacing = ImVec2(8, 8);
  style.ItemInnerSpacing = ImVec2(8, 4);
  style.CellPadding = ImVec2(4, 4);
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowRounding = 6;
  style.PopupRounding = 6;
  style.FrameRounding = 4;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 3;
  style.WindowTitleAlign = ImVec2(0.0f, 0.5f);
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = 1;

  auto set = [&](ImGuiCol id, const ImVec4& colour) { style.Colors[id] = colour; };
  set(ImGuiCol_Text, text);
  set(ImGuiCol_TextDisabled, textQuiet);
  set(ImGuiCol_WindowBg, panel);
  set(ImGuiCol_ChildBg, faded(panel, 0.0f));
  set(ImGuiCol_PopupBg, popup);
  set(ImGuiCol_Border, fieldFill);
  set(ImGuiCol_FrameBg, field);
  set(ImGuiCol_FrameBgHovered, fieldHover);
  set(ImGuiCol_FrameBgActive, fieldHover);
  set(ImGuiCol_TitleBg, popup);
  set(ImGuiCol_TitleBgActive, popup);
  set(ImGuiCol_MenuBarBg, panel);
  set(ImGuiCol_ScrollbarBg, faded(panel, 0.0f));
  set(ImGuiCol_ScrollbarGrab, fieldFill);
  set(ImGuiCol_ScrollbarGrabHovered, fieldFill);
  set(ImGuiCol_ScrollbarGrabActive, fieldFill);
  set(ImGuiCol_CheckMark, text);
  set(ImGuiCol_SliderGrab, textQuiet);
  set(ImGuiCol_SliderGrabActive, text);
  set(ImGuiCol_Button, fieldHover);
  set(ImGuiCol_ButtonHovered, fieldFill);
  set(ImGuiCol_ButtonActive, fieldFill);
  set(ImGuiCol_Header, field);
  set(ImGuiCol_HeaderHovered, fieldHover);
  set(ImGuiCol_HeaderActive, fieldFill);
  set(ImGuiCol_Separator, line);
  set(ImGuiCol_PlotHistogram, accent);
  set(ImGuiCol_TextSelectedBg, faded(accent, 0.35f));
  set(ImGuiCol_NavHighlight, accent);
  set(ImGuiCol_ModalWindowDimBg, ImVec4(0, 0, 0, 0.35f));
}

}  // namespace loomlight
