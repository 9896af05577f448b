#include "ui/widgets/fields.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <limits>

#include "core/base/rgb.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/keys.h"
#include "ui/words/field_words.h"

namespace loomlight {
namespace {

constexpr double kRestSeconds = 0.5;

/// Says that a list opens here.
void drawChevron(Ui& ui, ImVec2 centre) {
  const float w = ui.px(4), h = ui.px(2);
  const ImVec2 points[] = {{centre.x - w, centre.y - h}, {centre.x, centre.y + h}, {centre.x + w, centre.y - h}};
  ImGui::GetWindowDrawList()->AddPolyline(points, 3, packed(ui.theme.textQuiet), 0, ui.px(1.5f));
}

}  // namespace

ImVec4 toDisplayColour(const Rgb& linear) {
  const Rgb display = clippedSrgbFromLinear(linear);
  return ImVec4(display.x, display.y, display.z, 1.0f);
}

Rgb toLinearColour(const ImVec4& display) {
  return linearFromSrgb(Rgb(display.x, display.y, display.z));
}

void refuseText(Ui& ui, ImGuiID field, std::string problem) {
  ui.memory.failed = field;
  ui.memory.failedAt = ui.time;
  ui.memory.failure = std::move(problem);
}

void showRefusal(Ui& ui, ImGuiID field, ImVec2 min, ImVec2 max) {
  constexpr double kShown_s = 6;
  FieldMemory& memory = ui.memory;
  if (memory.failed != field) return;
  if (ui.time - memory.failedAt > kShown_s || memory.typing == field || memory.scrubbing == field) {
    memory.failed = 0;
    return;
  }
  ui.wakeWithin(0.5);
  const std::string& problem = memory.failure;
  ImGui::GetWindowDrawList()->AddRect(min, max, packed(ui.theme.error), ImGui::GetStyle().FrameRounding);
  ImDrawList& over = *ImGui::GetForegroundDrawList();
  const ImVec2 size = ImGui::CalcTextSize(problem.c_str());
  const float pad = ui.px(8);
  const float left = std::max(ui.px(4), max.x - size.x - 2 * pad);
  const ImVec2 corner(left, max.y + ui.px(4)), far(left + size.x + 2 * pad, corner.y + size.y + pad);
  over.AddRectFilled(corner, far, packed(ui.theme.popup), ui.px(4));
  over.AddRect(corner, far, packed(ui.theme.error), ui.px(4));
  over.AddText(ImVec2(corner.x + pad, corner.y + pad / 2), packed(ui.theme.text), problem.c_str());
}

std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  constexpr const char* kEllipsis = "\xE2\x80\xA6";
  std::string part = text;
  while (!part.empty() && ImGui::CalcTextSize((part + kEllipsis).c_str()).x > width) {
    // A character of UTF-8 goes as a whole: its continuation bytes first, then what they continue.
    while (!part.empty() && (static_cast<unsigned char>(part.back()) & 0xC0) == 0x80) part.pop_back();
    if (!part.empty()) part.pop_back();
  }
  return part + kEllipsis;
}

void tellIfClipped(Ui& ui, const std::string& id, const char* text, float room) {
  if (ui.probe.watching() && ImGui::CalcTextSize(text).x > room + 0.5f) ui.probe.fact("clipped." + id, text);
}

std::string fitted(Ui& ui, const std::string& id, const char* text, float room, std::string& cut) {
  std::string shown = shortened(text, std::max(room, 0.0f) + 0.5f);
  if (shown == text) return shown;
  cut += (cut.empty() ? "" : "\n") + std::string(text);
  if (ui.probe.watching()) ui.probe.fact("shortened." + id, text);
  return shown;
}

std::string tooltipWith(const std::string& cut, const char* tooltip) {
  return cut.empty() || !*tooltip ? cut + tooltip : cut + "\n\n" + tooltip;
}

FieldRow beginRow(Ui& ui, const RowText& text) {
  const float all = ImGui::GetContentRegionAvail().x;
  const float own = *text.label ? ImGui::CalcTextSize(text.label).x + ui.px(12) : 0;
  const float label = text.standsAlone ? own : std::floor(kLabelShare * all);
  const float height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  FieldRow row{all - label, height, {}};
  const std::string shown = fitted(ui, text.id, text.label, label - ui.px(4), row.cut);
  const float y = corner.y + 0.5f * (height - ImGui::GetFontSize());
  draw.AddText(ImVec2(corner.x, y), packed(ui.theme.textQuiet), shown.c_str());
  ImGui::SetCursorScreenPos(ImVec2(corner.x + label, corner.y));
  return row;
}

void endRow(Ui& ui, const RowText& text, ImVec2 min, ImVec2 max, const std::string& cut) {
  ui.probe.record(text.id, min, max);
  const float left = ImGui::GetWindowPos().x + ImGui::GetStyle().WindowPadding.x;
  tooltipFor(ui, text.id.c_str(), ImVec2(left, min.y), max, tooltipWith(cut, text.tooltip).c_str());
}

void textLine(Ui& ui, const char* id, const std::string& text, const ImVec4& colour, float width) {
  std::string cut;
  const float room = width > 0 ? width : ImGui::GetContentRegionAvail().x;
  const std::string shown = fitted(ui, id, text.c_str(), room, cut);
  ImGui::TextColored(colour, "%s", shown.empty() ? " " : shown.c_str());
  ui.probe.recordItem(id);
  tooltipFor(ui, id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), cut.c_str());
}

void tooltipFor(Ui& ui, const char* id, ImVec2 min, ImVec2 max, const char* text) {
  if (!*text) return;
  const ImGuiID key = ImGui::GetID(id);
  FieldMemory& memory = ui.memory;
  const bool isOver = ImGui::IsMouseHoveringRect(min, max);
  if (isOver && memory.restingOn == key && ImGui::IsAnyMouseDown())
    memory.restingSince = std::numeric_limits<double>::max();  // until it comes again
  // While a field is typed into, the mouse still rests where it was.
  const bool isWindows = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (!isOver || (!isWindows && !ImGui::IsAnyMouseDown())) {
    if (memory.restingOn == key) memory.restingOn = 0;
    return;
  }
  if (memory.restingOn != key) {
    memory.restingOn = key;
    memory.restingSince = ui.time;
  }
  if (memory.restingSince > ui.time || ImGui::IsAnyItemActive() || memory.failed != 0) return;
  const double rested = ui.time - memory.restingSince;
  if (rested < kRestSeconds) {
    ui.wakeWithin(kRestSeconds - rested + 0.01);
    return;
  }
  if (ui.tooltipCorner) ImGui::SetNextWindowPos(*ui.tooltipCorner);
  ImGui::BeginTooltip();
  ui.probe.fact("tooltip", text);
  ImGui::PushTextWrapPos(ui.px(320));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ui.probe.record("tooltip", corner, ImVec2(corner.x + size.x, corner.y + size.y));
  ImGui::EndTooltip();
}

std::vector<const char*> choicesOf(const std::vector<std::string>& names) {
  std::vector<const char*> choices;
  choices.reserve(names.size());
  for (const std::string& name : names) choices.push_back(name.c_str());
  return choices;
}

/// Dear ImGui ends the name of a widget at "##", but not a text.
bool listLine(Ui& ui, const std::string& id, const char* name, bool chosen, const char* tooltip) {
  const bool pressed = ImGui::Selectable("##line", chosen);
  ui.probe.recordItem(id);
  tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), tooltip);
  ImGui::SameLine(0, 0);
  ImGui::TextUnformatted(name);
  return pressed;
}

bool choiceField(Ui& ui, const RowText& text, std::span<const char* const> names, int& chosen, const char* otherwise) {
  FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + row.width, min.y + row.height);
  ImGui::PushID(text.id.c_str());
  ImGui::SetNextItemWidth(row.width);
  bool changed = false;
  const char* shown = chosen >= 0 && chosen < static_cast<int>(names.size()) ? names[chosen] : otherwise;
  const float room = row.width - ui.px(28);
  const std::string preview = fitted(ui, text.id, shown, room, row.cut);
  if (ui.probe.watching()) ui.probe.fact(text.id, shown);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool open = ImGui::BeginCombo("##choice", nullptr, ImGuiComboFlags_HeightLarge | ImGuiComboFlags_NoArrowButton);
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  draw.AddText(ImVec2(min.x + padding.x, min.y + padding.y), ImGui::GetColorU32(ImGuiCol_Text), preview.c_str());
  if (!open) drawChevron(ui, ImVec2(max.x - ui.px(14), 0.5f * (min.y + max.y)));
  if (open) {
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
      ImGui::PushID(i);
      if (listLine(ui, text.id + "/" + names[i], names[i], i == chosen)) {
        changed = i != chosen;
        chosen = i;
      }
      ImGui::PopID();
    }
    if (keyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
  }
  ImGui::PopID();
  endRow(ui, text, min, max, row.cut);
  return changed;
}

bool segmentField(Ui& ui, const RowText& text, std::span<const char* const> names, int& chosen) {
  FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + row.width, min.y + row.height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(min, max, packed(ui.theme.field), rounding);
  ImGui::PushID(text.id.c_str());
  bool changed = false;
  const float width = row.width / static_cast<float>(names.size());
  const int shown = chosen;  // a click shows with the next frame, so that none has two of them lit
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const ImVec2 a(min.x + width * static_cast<float>(i), min.y), b(a.x + width, max.y);
    ImGui::SetCursorScreenPos(a);
    if (ImGui::InvisibleButton(names[i], ImVec2(width, row.height)) && i != chosen) {
      chosen = i;
      changed = true;
    }
    ui.probe.recordItem(text.id + "/" + names[i]);
    const bool on = i == shown;
    if (on || ImGui::IsItemHovered())
      draw.AddRectFilled(a, b, packed(on ? ui.theme.fieldFill : ui.theme.fieldHover), rounding);
    const std::string name = fitted(ui, text.id, names[i], width, row.cut);
    const ImVec2 size = ImGui::CalcTextSize(name.c_str());
    draw.AddText(ImVec2(0.5f * (a.x + b.x - size.x), 0.5f * (a.y + b.y - size.y)),
                 packed(on ? ui.theme.text : ui.theme.textQuiet), name.c_str());
    if (on)  // one step of grey is soon overlooked
      draw.AddRectFilled(ImVec2(a.x + ui.px(4), b.y - ui.px(2)), ImVec2(b.x - ui.px(4), b.y), packed(ui.theme.accent),
                         ui.px(1));
  }
  ImGui::PopID();
  endRow(ui, text, min, max, row.cut);
  return changed;
}

bool segmentField(Ui& ui, const RowText& text, std::span<const char* const> names, bool& second) {
  int chosen = second ? 1 : 0;
  const bool changed = segmentField(ui, text, names, chosen);
  second = chosen == 1;
  return changed;
}

bool switchField(Ui& ui, const RowText& text, bool& value) {
  return segmentField(ui, text, words::fields::offOn, value);
}

namespace {

bool textRow(Ui& ui, const RowText& text, std::string& value, const char* whenEmpty, ImGuiInputTextFlags flags) {
  const FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImGui::PushID(text.id.c_str());
  ImGui::SetNextItemWidth(row.width);
  ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);
  const bool changed = ImGui::InputTextWithHint("##text", whenEmpty, &value, flags);
  ImGui::PopItemFlag();
  ui.memory.tabOrder.pass(ImGui::GetItemID(), panelOfFields(), false);
  if (ImGui::IsItemActivated()) ui.memory.tabOrder.standOn(ImGui::GetItemID(), false);
  const char* const shown = value.empty() ? whenEmpty : value.c_str();
  const bool goesOn = ImGui::CalcTextSize(shown).x > row.width - ui.px(16);
  if (goesOn && value.empty() && ui.probe.watching()) ui.probe.fact("shortened." + text.id, whenEmpty);
  if (goesOn && !ImGui::IsItemActive()) {  // a text that goes on fades out
    const ImVec2 max(min.x + row.width, min.y + row.height);
    const ImVec4& field = ImGui::IsItemHovered() ? ui.theme.fieldHover : ui.theme.field;
    const ImU32 clear = packed(field, 0), full = packed(field);
    const float rounding = ImGui::GetStyle().FrameRounding, end = max.x - 2 * rounding;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilledMultiColor(ImVec2(end - ui.px(16), min.y), ImVec2(end, max.y), clear, full, full, clear);
    draw.AddRectFilled(ImVec2(end, min.y), max, full, rounding, ImDrawFlags_RoundCornersRight);
  }
  ImGui::PopID();
  RowText explained = text;  // what fades out is read there
  const std::string whole = tooltipWith(goesOn ? shown : "", text.tooltip);
  explained.tooltip = whole.c_str();
  endRow(ui, explained, min, ImVec2(min.x + row.width, min.y + row.height), row.cut);
  return changed;
}

}  // namespace

bool textField(Ui& ui, const RowText& text, std::string& value, const char* whenEmpty) {
  return textRow(ui, text, value, whenEmpty, 0);
}

bool enteredField(Ui& ui, const RowText& text, std::string& value, const char* whenEmpty) {
  return textRow(ui, text, value, whenEmpty, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
}

bool colourPicker(Ui& ui, const std::string& id, Rgb& linear) {
  const ImVec4 display = toDisplayColour(linear);
  float edited[3] = {display.x, display.y, display.z};
  ImGui::SetNextItemWidth(ui.px(240));
  const bool touched = ImGui::ColorPicker3("##picker", edited,
                                           ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB |
                                               ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueBar);
  ui.probe.recordItem(id + "/picker");
  // The picker goes by way of hue and saturation, and the fabric keeps absorptions: a colour that is held still comes
  // back with other last digits in each frame. Only what a display can show is an edit.
  constexpr float kQuarterStep = 0.25f / 255.0f;
  const bool isSeen = std::abs(edited[0] - display.x) > kQuarterStep ||
                      std::abs(edited[1] - display.y) > kQuarterStep || std::abs(edited[2] - display.z) > kQuarterStep;
  if (!touched || !isSeen) return false;
  linear = toLinearColour(ImVec4(edited[0], edited[1], edited[2], 1.0f));
  return true;
}

bool colourField(Ui& ui, const RowText& text, Rgb& linear) {
  const FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImGui::PushID(text.id.c_str());
  bool changed = false;
  constexpr ImGuiColorEditFlags kFlat = ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop;
  if (ImGui::ColorButton("##swatch", toDisplayColour(linear), kFlat, ImVec2(row.width, row.height)))
    ImGui::OpenPopup("picker");
  if (ImGui::BeginPopup("picker")) {
    changed = colourPicker(ui, text.id, linear);
    if (keyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopID();
  endRow(ui, text, min, ImVec2(min.x + row.width, min.y + row.height), row.cut);
  return changed;
}

void readout(Ui& ui, const RowText& text, const std::string& value) {
  FieldRow row = beginRow(ui, text);
  ui.probe.fact(text.id, value);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + row.width, min.y + row.height);
  const std::string shown = fitted(ui, text.id, value.c_str(), row.width - ui.px(8), row.cut);
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  const float y = min.y + 0.5f * (row.height - size.y);
  ImGui::GetWindowDrawList()->AddText(ImVec2(max.x - ui.px(8) - size.x, y), packed(ui.theme.text), shown.c_str());
  ImGui::Dummy(ImVec2(row.width, row.height));
  endRow(ui, text, min, max, row.cut);
}

bool button(Ui& ui, const char* id, const char* label, float width, bool enabled, const char* tooltip) {
  ImGui::PushID(id);
  if (!enabled) ImGui::BeginDisabled();
  std::string cut;
  const float room = width > 0   ? width
                     : width < 0 ? ImGui::GetContentRegionAvail().x + width
                                 : ImGui::CalcTextSize(label).x;
  const std::string shown = fitted(ui, id, label, room, cut);
  const bool pressed = ImGui::Button(shown.c_str(), ImVec2(width, 0));
  if (!enabled) ImGui::EndDisabled();
  ImGui::PopID();
  ui.probe.recordItem(id);
  tooltipFor(ui, id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), tooltipWith(cut, tooltip).c_str());
  return pressed;
}

bool mainButton(Ui& ui, const char* id, const char* label, float width, bool enabled, const char* tooltip) {
  if (!enabled) return button(ui, id, label, width, false, tooltip);
  ImVec4 ground = ui.theme.text;
  ground.w = 0.88f;
  ImGui::PushStyleColor(ImGuiCol_Button, ground);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ui.theme.text);
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, ui.theme.text);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.panel);
  const bool pressed = button(ui, id, label, width, true, "");
  ImGui::PopStyleColor(4);
  tooltipFor(ui, id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), tooltip);  // in the colours of a tooltip
  return pressed;
}

bool swatch(Ui& ui, const char* id, const ImVec4& colour, float size, bool selected, const char* tooltip) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(size, size));
  const ImVec2 max(min.x + size, min.y + size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float inset = ui.px(3);
  const ImVec2 a(min.x + inset, min.y + inset), b(max.x - inset, max.y - inset);
  draw.AddRectFilled(a, b, packed(colour), ui.px(3));
  draw.AddRect(a, b, packed(ui.theme.text, 0.18f), ui.px(3));  // ecru is seen on a light panel, black on a dark one
  if (selected || ImGui::IsItemHovered())
    draw.AddRect(min, max, packed(selected ? ui.theme.accent : ui.theme.textQuiet), ui.px(5), 0, ui.px(1.5f));
  ui.probe.record(id, min, max);
  tooltipFor(ui, id, min, max, tooltip);
  return pressed;
}

void heading(Ui& ui, const char* text) {
  ImGui::Dummy(ImVec2(0, ui.px(2)));
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

bool foldingHeading(Ui& ui, const char* id, const char* text, const char* tooltip, bool& open) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()), max(min.x + size.x, min.y + size.y);
  if (ImGui::InvisibleButton(id, size)) open = !open;
  ui.probe.recordItem(id);
  const ImU32 ink = packed(ImGui::IsItemHovered() ? ui.theme.text : ui.theme.textQuiet);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float r = ui.px(3), x = min.x + ui.px(4), y = 0.5f * (min.y + max.y);
  const ImVec2 shut[] = {{x - 0.5f * r, y - r}, {x + 0.5f * r, y}, {x - 0.5f * r, y + r}};
  const ImVec2 unfolded[] = {{x - r, y - 0.5f * r}, {x, y + 0.5f * r}, {x + r, y - 0.5f * r}};
  draw.AddPolyline(open ? unfolded : shut, 3, ink, 0, ui.px(1.5f));
  ImGui::PushFont(ui.fonts.strong);
  draw.AddText(ImVec2(min.x + ui.px(16), y - 0.5f * ImGui::GetFontSize()), packed(ui.theme.text), text);
  ImGui::PopFont();
  tooltipFor(ui, id, min, max, tooltip);
  return open;
}

void hint(Ui& ui, const std::string& text) {
  hint(ui, text, ui.theme.textQuiet);
}

void hint(Ui& ui, const std::string& text, const ImVec4& colour) {
  ImGui::PushFont(ui.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

}  // namespace loomlight
