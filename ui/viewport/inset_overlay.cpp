#include "ui/viewport/inset_overlay.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/words/menu_words.h"
#include "ui/words/viewport_words.h"

namespace loomlight {
namespace {

constexpr ImU32 kGround = IM_COL32(18, 18, 19, 238);

ImVec2 plus(ImVec2 a, ImVec2 b) {
  return {a.x + b.x, a.y + b.y};
}

/// Light between two dark lines: it reads on any cloth. Drawn around the inset, but never outside of the viewport.
void drawBorder(Ui& ui, ImVec2 min, ImVec2 max, ImVec2 viewportMin, ImVec2 viewportMax) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line = std::max(1.0f, std::floor(ui.px(1)));
  const auto ring = [&](float out, ImU32 colour) {
    const ImVec2 a(std::max(min.x - out, viewportMin.x), std::max(min.y - out, viewportMin.y));
    const ImVec2 b(std::min(max.x + out, viewportMax.x), std::min(max.y + out, viewportMax.y));
    draw.AddRectFilled(a, {b.x, a.y + line}, colour);
    draw.AddRectFilled({a.x, b.y - line}, b, colour);
    draw.AddRectFilled({a.x, a.y + line}, {a.x + line, b.y - line}, colour);
    draw.AddRectFilled({b.x - line, a.y + line}, {b.x, b.y - line}, colour);
  };
  ring(2 * line, IM_COL32(0, 0, 0, 150));
  ring(0, IM_COL32(0, 0, 0, 150));
  ring(line, IM_COL32(240, 240, 240, 255));
}

/// The caption in the lower left corner of the inset, with the scale of the difference behind it; of an inset that is
/// too narrow for it, below, or where the viewport ends there, across.
void drawCaption(Ui& ui, const InsetModel& model, ImVec2 min, ImVec2 max, ImVec2 viewportMin, ImVec2 viewportMax) {
  if (model.caption.empty()) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  const float pad = ui.px(6), height = ImGui::GetFontSize() + pad;
  const float swatch = model.scale.empty() ? 0 : ui.px(64);
  const ImVec2 endSize = swatch > 0 ? ImGui::CalcTextSize(model.scaleEnd.c_str()) : ImVec2(0, 0);
  const float scaleWidth = swatch > 0 ? swatch + endSize.x + 3 * pad : 0;
  const float most = viewportMax.x - viewportMin.x - 4 * pad;
  const bool withScale = swatch > 0 && ImGui::CalcTextSize(model.caption.c_str()).x + scaleWidth <= most;
  const std::string text = shortened(model.caption, most - (withScale ? scaleWidth : 0));
  const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
  const float width = textWidth + 2 * pad + (withScale ? scaleWidth : 0);
  const bool inside = width + 2 * pad <= max.x - min.x;
  const bool below = !inside && max.y + pad + height <= viewportMax.y;
  const float x = inside ? min.x + pad : std::clamp(min.x, viewportMin.x, viewportMax.x - width);
  const ImVec2 corner(x, below ? max.y + pad : max.y - pad - height), far(corner.x + width, corner.y + height);
  draw.AddRectFilled(corner, far, kGround, ui.px(3));
  draw.AddText({corner.x + pad, corner.y + 0.5f * pad}, packed(Theme::dark().text), text.c_str());
  ui.probe.record("lens.caption", corner, far);
  if (withScale) {
    const float left = corner.x + textWidth + 3 * pad, step = swatch / static_cast<float>(model.scale.size());
    for (size_t i = 0; i < model.scale.size(); ++i) {
      const float x = left + step * static_cast<float>(i);
      draw.AddRectFilled({x, corner.y + pad}, {x + step, far.y - pad}, packed(model.scale[i]));
    }
    draw.AddText({left + swatch + pad, corner.y + 0.5f * pad}, packed(Theme::dark().textQuiet), model.scaleEnd.c_str());
  }
  ImGui::PopFont();
}

/// Child windows lie above the viewport and take the mouse there.
bool beginBox(const char* id, ImVec2 min, ImVec2 size) {
  ImGui::SetCursorScreenPos(min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const bool open =
      ImGui::BeginChild(id, size, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  return open;
}

bool barButton(Ui& ui, const char* id, const char* label, ImVec2 min, ImVec2 size, bool chosen) {
  ImGui::SetCursorScreenPos(min);
  const bool pressed = ImGui::InvisibleButton(id, size);
  const ImVec2 max = plus(min, size);
  const Theme theme = Theme::dark();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (chosen || ImGui::IsItemHovered())
    draw.AddRectFilled(min, max, packed(chosen ? theme.fieldFill : theme.fieldHover), ui.px(3));
  const ImVec2 text = ImGui::CalcTextSize(label);
  draw.AddText({min.x + 0.5f * (size.x - text.x), min.y + 0.5f * (size.y - text.y)},
               packed(chosen || ImGui::IsItemHovered() ? theme.text : theme.textQuiet), label);
  ui.probe.recordItem(id);
  if (ui.probe.watching() && text.x > size.x) ui.probe.fact(std::string("clipped.") + id, label);
  return pressed;
}

void drawCross(Ui& ui, ImVec2 centre, bool lit) {
  const float r = ui.px(4);
  const ImU32 colour = packed(lit ? Theme::dark().text : Theme::dark().textQuiet);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine({centre.x - r, centre.y - r}, {centre.x + r, centre.y + r}, colour, ui.px(1.5f));
  draw.AddLine({centre.x - r, centre.y + r}, {centre.x + r, centre.y - r}, colour, ui.px(1.5f));
}

/// Moves the inset, says what it is, switches between fibres and difference, closes it.
void bar(Ui& ui, InsetView& view, ImVec2 origin, int viewportWidth, int viewportHeight) {
  ImGui::PushFont(ui.fonts.small);
  const float height = ui.px(24), segment = ui.px(72), inset = ui.px(2), cross = ui.px(22);
  const float title = ImGui::CalcTextSize(words::menu::truthLens.label).x + ui.px(16);
  const float buttons = 2 * segment + cross + 3 * inset;
  const auto insetWidth = static_cast<float>(view.rect.width);
  const ImVec2 size(std::max(insetWidth, title + buttons), height);
  const ImVec2 min = plus(origin, besideInset(view.rect, size, ui.px(4), viewportWidth)), max = plus(min, size);
  beginBox("lens.bar_box", min, size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, kGround, ui.px(4));
  const float y = min.y + inset, tall = height - 2 * inset;
  float x = max.x - cross - inset;
  bool closed = barButton(ui, "lens.close", "", {x, y}, {cross, tall}, false);
  drawCross(ui, {x + 0.5f * cross, y + 0.5f * tall}, ImGui::IsItemHovered());
  tooltipFor(ui, "lens.close", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), words::lens::closeHelp);
  x -= segment + inset;
  if (barButton(ui, "lens.difference", words::lens::difference.label, {x, y}, {segment, tall}, view.showsDifference))
    view.showsDifference = true;
  tooltipFor(ui, "lens.difference", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), words::lens::difference.help);
  x -= segment;
  if (barButton(ui, "lens.fibres", words::lens::fibres.label, {x, y}, {segment, tall}, !view.showsDifference))
    view.showsDifference = false;
  tooltipFor(ui, "lens.fibres", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), words::lens::fibres.help);
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("lens.bar", {x - min.x, height});
  ui.probe.recordItem("lens.bar");
  const bool held = ImGui::IsItemActive();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsItemActivated()) view.grab(InsetView::Grip::move, mouse);
  if (held) view.drag(mouse, viewportWidth, viewportHeight);
  if (ImGui::IsItemDeactivated()) view.letGo(viewportWidth, viewportHeight);
  if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(cursorOf(InsetView::Grip::move));
  draw.AddText({min.x + ui.px(8), min.y + 0.5f * (height - ImGui::GetFontSize())}, packed(Theme::dark().text),
               words::menu::truthLens.label);
  ImGui::EndChild();
  ImGui::PopFont();
  if (closed) view.close();
}

/// What is in the way, and what can be done about it, in the middle of the inset.
InsetEdit troubleBox(Ui& ui, const InsetModel& model, const InsetView& view, ImVec2 origin, int viewportWidth,
                     int viewportHeight) {
  InsetEdit edit;
  const float pad = ui.px(12), width = std::min(ui.px(320), static_cast<float>(viewportWidth));
  const float wrap = width - 2 * pad;
  const bool buttons = !model.remedy.empty() || model.limitMatters;
  const float text = ImGui::CalcTextSize(model.trouble.c_str(), nullptr, false, wrap).y;
  const float height = 2 * pad + text + (buttons ? ImGui::GetFrameHeight() + pad : 0);
  const auto centred = [](int begin, int length, float size, int room) {
    return std::clamp(static_cast<float>(begin) + 0.5f * (static_cast<float>(length) - size), 0.0f,
                      std::max(0.0f, static_cast<float>(room) - size));
  };
  const ImVec2 min = plus(origin, {centred(view.rect.x, view.rect.width, width, viewportWidth),
                                   centred(view.rect.y, view.rect.height, height, viewportHeight)});
  beginBox("lens.trouble_box", min, {width, height});
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, plus(min, {width, height}), packed(ui.theme.popup), ui.px(6));
  draw.AddRect(min, plus(min, {width, height}), packed(ui.theme.fieldFill), ui.px(6));
  ui.probe.record("lens.trouble", min, plus(min, {width, height}));
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), plus(min, {pad, pad}), packed(ui.theme.text),
               model.trouble.c_str(), nullptr, wrap);
  ImGui::SetCursorScreenPos(plus(min, {pad, pad + text + pad}));
  const float half = 0.5f * (wrap - ui.px(8));
  if (!model.remedy.empty()) {
    edit.remedy = button(ui, "lens.remedy", model.remedy.c_str(), half, true, words::lens::remedyHelp);
    ImGui::SameLine();
  }
  if (model.limitMatters)
    edit.changeLimit =
        button(ui, "lens.limit", words::lens::changeLimit.label, half, true, words::lens::changeLimit.help);
  ImGui::EndChild();
  return edit;
}

}  // namespace

InsetEdit insetOverlay(Ui& ui, const InsetModel& model, InsetView& view, ImVec2 origin, int viewportWidth,
                       int viewportHeight) {
  if (!view.on || !view.placed) return {};
  view.keepWithin(viewportWidth, viewportHeight);
  const InsetRect& rect = view.rect;
  const auto corner = [&](int x, int y) { return plus(origin, {static_cast<float>(x), static_cast<float>(y)}); };
  const ImVec2 min = corner(rect.x, rect.y), max = corner(rect.x + rect.width, rect.y + rect.height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (model.picture) {
    const InsetRect& w = model.window;
    draw.PushClipRect(min, max, true);
    draw.AddImage(model.picture, corner(w.x, w.y), corner(w.x + w.width, w.y + w.height));
    draw.PopClipRect();
  }
  if (model.laying) {
    const float along = min.x + static_cast<float>(model.progress) * (max.x - min.x);
    draw.AddRectFilled(min, {along, min.y + ui.px(3)}, packed(ui.theme.accent));
  }
  drawBorder(ui, min, max, origin, corner(viewportWidth, viewportHeight));
  drawCaption(ui, model, min, max, origin, corner(viewportWidth, viewportHeight));
  ui.probe.record("lens", min, max);
  InsetEdit edit;
  if (!model.trouble.empty()) edit = troubleBox(ui, model, view, origin, viewportWidth, viewportHeight);
  bar(ui, view, origin, viewportWidth, viewportHeight);
  return edit;
}

void insetButton(Ui& ui, InsetView& view, float size) {
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size, min.y + ImGui::GetFrameHeight());
  if (ImGui::InvisibleButton("view.lens", {size, max.y - min.y})) view.toggle();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool lit = ImGui::IsItemHovered();
  const ImVec4& ground = view.on ? ui.theme.accent : lit ? ui.theme.fieldFill : ui.theme.fieldHover;
  draw.AddRectFilled(min, max, packed(ground), ImGui::GetStyle().FrameRounding);
  // A frame around a few fibres.
  const ImU32 ink = packed(view.on ? ui.theme.onAccent : ui.theme.text);
  const ImVec2 centre(std::floor(0.5f * (min.x + max.x)), std::floor(0.5f * (min.y + max.y)));
  const float w = ui.px(8), h = ui.px(6);
  draw.AddRect({centre.x - w, centre.y - h}, {centre.x + w, centre.y + h}, ink, ui.px(1.5f), 0, ui.px(1.25f));
  for (int i = -1; i <= 1; ++i) {
    const float x = centre.x + ui.px(4) * static_cast<float>(i);
    draw.AddLine({x - ui.px(1.5f), centre.y + ui.px(3.5f)}, {x + ui.px(1.5f), centre.y - ui.px(3.5f)}, ink,
                 ui.px(1.25f));
  }
  ui.probe.record("view.lens", min, max);
  tooltipFor(ui, "view.lens", min, max, words::lens::help);
}

}  // namespace loomlight
