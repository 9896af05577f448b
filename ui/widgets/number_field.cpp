#include <fmt/core.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <cmath>

#include "ui/widgets/field_row.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/number_text.h"
#include "ui/words/field_words.h"

namespace loomlight {
namespace {

constexpr float kDragThreshold = 3.0f;

double roundTo(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return std::round(value * unit) / unit;
}

/// As many as the style says; small values on a logarithmic scale keep three significant digits.
int decimalsOf(const NumberStyle& style, double value) {
  if (!style.logarithmic || value <= 0) return style.decimals;
  return std::clamp(static_cast<int>(2 - std::floor(std::log10(value))), style.decimals, 6);
}

/// Enough digits to say the value, and no more than the style wants.
std::string written(const NumberStyle& style, double value) {
  const int decimals = decimalsOf(style, value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > style.decimals && text.find('.') != std::string::npos) {
    const size_t keep = text.size() - static_cast<size_t>(decimals - style.decimals);
    while (text.size() > keep && text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

/// What stands behind the value.
const char* unitOf(const NumberStyle& style, double value) {
  return value == 1 && *style.unitOfOne ? style.unitOfOne : style.unit;
}

/// Where a logarithmic scale begins, for ranges that begin at 0 too.
double lowest(const NumberStyle& style) {
  return style.min > 0 ? style.min : style.max * 1e-5;
}

double scrubbed(const NumberStyle& style, double value, double pixels) {
  const ImGuiIO& io = ImGui::GetIO();
  const double speed = io.KeyShift ? 0.1 : io.KeyCtrl ? 10.0 : 1.0;
  if (style.logarithmic) {
    const double moved = std::max(value, lowest(style)) * std::exp(0.008 * pixels * speed);
    return moved <= lowest(style) ? style.min : moved;
  }
  const double perPixel = style.perPixel > 0 ? style.perPixel : (style.max - style.min) / 300.0;
  return value + perPixel * pixels * speed;
}

double fraction(const NumberStyle& style, double value) {
  if (!style.logarithmic) return std::clamp((value - style.min) / (style.max - style.min), 0.0, 1.0);
  if (value <= lowest(style)) return 0.0;
  return std::clamp(std::log(value / lowest(style)) / std::log(style.max / lowest(style)), 0.0, 1.0);
}

void drawValue(Ui& ui, const NumberStyle& style, double value, const ImRect& box, bool lit) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(box.Min, box.Max, packed(lit ? ui.theme.fieldHover : ui.theme.field), rounding);
  // How far along its range; a range on both sides of zero fills from zero.
  const double zero = style.min < 0 && style.max > 0 ? fraction(style, 0.0) : 0.0;
  const double here = fraction(style, value);
  const float from = static_cast<float>(std::min(zero, here)) * box.GetWidth();
  const float to = static_cast<float>(std::max(zero, here)) * box.GetWidth();
  if (to - from > 1) {
    draw.PushClipRect(ImVec2(box.Min.x + from, box.Min.y), ImVec2(box.Min.x + to, box.Max.y), true);
    draw.AddRectFilled(box.Min, box.Max, packed(ui.theme.fieldFill, 0.75f), rounding);
    draw.PopClipRect();
  }
  const std::string number = value == 0 && *style.none ? style.none : written(style, value);
  const char* const unit = unitOf(style, value);
  const ImVec2 unitSize = ImGui::CalcTextSize(unit);
  const ImVec2 numberSize = ImGui::CalcTextSize(number.c_str());
  const float pad = ui.px(8);
  const float y = box.Min.y + 0.5f * (box.GetHeight() - numberSize.y);
  float x = box.Max.x - pad;
  if (*unit) {
    x -= unitSize.x;
    draw.AddText(ImVec2(x, y), packed(ui.theme.textQuiet), unit);
    x -= ui.px(4);
  }
  draw.AddText(ImVec2(x - numberSize.x, y), packed(ui.theme.text), number.c_str());
}

std::string objectionTo(std::string_view text, const NumberStyle& style) {
  if (hasDoubtfulComma(text)) return words::fields::doubtfulComma;
  if (std::string own = style.objection ? style.objection(text) : ""; !own.empty()) return own;
  return fmt::format(words::fields::expected, style.min, style.max, *style.unit ? " " : "", style.unit,
                     *style.otherwise ? words::fields::orOtherwise : "", style.otherwise);
}

/// The open text of a field. True when it was accepted.
bool typeValue(Ui& ui, const NumberStyle& style, double& value, ImGuiID id, float width) {
  FieldMemory& memory = ui.memory;
  ImGui::SetNextItemWidth(width);
  if (memory.justOpened) focusNextItem();
  ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);  // Tab is ours
  memory.typedAt = ImGui::GetFrameCount();
  const bool confirmed = ImGui::InputText("##text", &memory.text,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopItemFlag();
  const bool entered = confirmed || memory.tabOrder.isGoing();
  const bool cancelled = ImGui::IsItemDeactivated() && keyPressed(ImGuiKey_Escape);
  const bool left = ImGui::IsItemDeactivated() && !memory.justOpened;
  memory.justOpened = false;
  // A dialog that opens in the same moment takes the keys before the text has them, and would never close by Escape.
  constexpr int kFramesToListen = 4;
  memory.unheard = ImGui::IsItemActive() ? 0 : memory.unheard + 1;
  if (memory.unheard > 0) ui.wakeWithin(0);
  if (memory.unheard > kFramesToListen) {
    memory.typing = 0;
    return false;
  }
  if (cancelled) {
    memory.typing = 0;
    memory.tabOrder.standOn(id, true);
    return false;
  }
  if (!entered && !left) return false;
  memory.typing = 0;
  if (confirmed) memory.tabOrder.standOn(id, true);
  if (memory.text == memory.openedAs) return false;  // it is rounded: to look at a number is no edit
  std::optional<double> typed = numberIn(style.unit, memory.text);
  if (!typed && style.parse) typed = style.parse(memory.text);
  if (typed && *typed >= style.min && *typed <= style.max) {
    const bool changed = *typed != value;
    value = *typed;
    return changed;
  }
  memory.tabOrder.stay();
  refuseText(ui, id, objectionTo(memory.text, style));
  return false;
}

void openText(Ui& ui, const NumberStyle& style, double value, ImGuiID id) {
  ui.memory.typing = id;
  ui.memory.text = ui.memory.openedAs = written(style, value);
  ui.memory.justOpened = true;
  ui.memory.typedAt = ImGui::GetFrameCount();
  ui.memory.unheard = 0;
  ui.wakeWithin(0);
}

/// Opens the field that Tab has come to, in sight.
void arriveByKeys(Ui& ui, const NumberStyle& style, double value, ImGuiID id, const ImRect& box) {
  ui.memory.tabOrder.pass(id, panelOfFields(), true);
  const bool another = ui.memory.typing != 0 && ui.memory.typing != id;  // whose text is taken first
  if (another || !ui.memory.tabOrder.arrive(id)) return;
  openText(ui, style, value, id);
  const ImRect& seen = ImGui::GetCurrentWindow()->InnerClipRect;
  if (box.Min.y < seen.Min.y || box.Max.y > seen.Max.y)
    ImGui::SetScrollFromPosY(box.Min.y - ImGui::GetWindowPos().y, 0.5f);
}

bool scrubValue(Ui& ui, const NumberStyle& style, double& value, ImGuiID id) {
  FieldMemory& memory = ui.memory;
  if (ImGui::IsItemActivated()) {
    memory.scrubbing = id;
    memory.scrubValue = value;
    memory.scrubMoved = false;
  }
  if (memory.scrubbing != id) return false;
  if (!ImGui::IsItemActive()) {
    memory.scrubbing = 0;
    if (!memory.scrubMoved) {
      openText(ui, style, value, id);
      memory.tabOrder.standOn(id, false);
    }
    return false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  if (!memory.scrubMoved && !ImGui::IsMouseDragging(ImGuiMouseButton_Left, kDragThreshold * ui.scale)) return false;
  memory.scrubMoved = true;
  if (io.MouseDelta.x == 0) return false;
  memory.scrubValue = std::clamp(scrubbed(style, memory.scrubValue, io.MouseDelta.x / ui.scale), style.min, style.max);
  const double rounded =
      std::clamp(roundTo(memory.scrubValue, decimalsOf(style, memory.scrubValue)), style.min, style.max);
  const bool changed = rounded != value;
  value = rounded;
  return changed;
}

/// A page or a panel that is left takes with it the field that was open or held there: it is not so when it comes back.
void closeWhatIsGone(FieldMemory& memory) {
  if (memory.typing != 0 && ImGui::GetFrameCount() - memory.typedAt > 1) memory.typing = 0;
  if (!ImGui::IsAnyItemActive()) memory.scrubbing = 0;
}

}  // namespace

bool numberField(Ui& ui, const RowText& text, const NumberStyle& style, double& value) {
  const FieldRow row = beginRow(ui, text);
  ImGui::PushID(text.id.c_str());
  const ImGuiID id = ImGui::GetID("field");
  bool changed = false;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImRect box(corner, ImVec2(corner.x + row.width, corner.y + row.height));
  arriveByKeys(ui, style, value, id, box);
  if (ui.memory.typing == id) {
    changed = typeValue(ui, style, value, id, row.width);
  } else {
    ImGui::InvisibleButton("scrub", ImVec2(row.width, row.height));
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    changed = scrubValue(ui, style, value, id);
    drawValue(ui, style, value, box, lit);
    if (ui.probe.watching()) ui.probe.fact(text.id, fmt::format("{} {}", written(style, value), unitOf(style, value)));
    if (ui.memory.tabOrder.isSeenOn(id))
      ImGui::GetWindowDrawList()->AddRect(box.Min, box.Max, packed(ui.theme.accent), ImGui::GetStyle().FrameRounding);
  }
  showRefusal(ui, id, box.Min, box.Max);
  ImGui::PopID();
  endRow(ui, text, box.Min, box.Max, row.cut);
  return changed;
}

ImGuiID panelOfFields() {
  return ImGui::GetCurrentWindow()->RootWindow->ID;
}

void walkNumbers(Ui& ui) {
  closeWhatIsGone(ui.memory);
  TabOrder& tabOrder = ui.memory.tabOrder;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) tabOrder.hide();
  if (!keyPressed(ImGuiKey_Tab) || io.KeyCtrl) return;
  std::optional<ImGuiID> dialog;
  if (const auto& open = ImGui::GetCurrentContext()->OpenPopupStack; !open.empty()) {
    const ImGuiWindow* const window = open.back().Window;
    if (!window || !(window->Flags & ImGuiWindowFlags_Modal)) return;  // a list, or the picker of a colour
    dialog = window->ID;
  }
  tabOrder.go(io.KeyShift ? -1 : 1, dialog);
  ui.wakeWithin(0);
}

bool wholeNumberField(Ui& ui, const RowText& text, const char* unit, int min, int max, int& value,
                      const char* unitOfOne) {
  NumberStyle style;
  style.unit = unit;
  style.unitOfOne = unitOfOne;
  style.min = min;
  style.max = max;
  style.decimals = 0;
  style.perPixel = std::clamp((max - min) / 300.0, 0.04, 1.0);
  double number = value;
  if (!numberField(ui, text, style, number)) return false;
  const int rounded = static_cast<int>(std::lround(number));
  const bool changed = rounded != value;
  value = rounded;
  return changed;
}

}  // namespace loomlight
