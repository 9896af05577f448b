#include "ui/draft/order_field.h"

#include <fmt/core.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/weave/yarn_order.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/fabric/yarn/yarn_name.h"
#include "ui/widgets/field_row.h"
#include "ui/words/stripe_words.h"

namespace loomlight {
namespace {

// A jacquard's order could be sixteen thousand letters long: it is shown, but only the bars edit it.
constexpr size_t kLongest = 4096;

/// Breaks the lines of a text at blanks, which keep their number: the cursor stays where it is.
void breakLines(char* text, int length, float width) {
  std::replace(text, text + length, '\n', ' ');
  int lineStart = 0, lastBlank = -1;
  for (int i = 0; i <= length; ++i) {
    if (i < length && text[i] != ' ') continue;
    if (ImGui::CalcTextSize(text + lineStart, text + i).x > width && lastBlank > lineStart) {
      text[lastBlank] = '\n';
      lineStart = lastBlank + 1;
    }
    lastBlank = i;
  }
}

struct Typing {
  float room = 0;
  bool opensNow = false;
};

/// The first click takes all of it, as in fields of numbers: another order is typed at once.
int breakWhileTyped(ImGuiInputTextCallbackData* data) {
  Typing& typing = *static_cast<Typing*>(data->UserData);
  breakLines(data->Buf, data->BufTextLen, typing.room);
  data->BufDirty = true;
  if (std::exchange(typing.opensNow, false)) data->SelectAll();
  return 0;
}

/// The first yarn that an order names beyond those that there are and beyond one that is neither there nor named.
std::optional<int> beyondGap(const std::vector<int>& sequence, int yarns) {
  const std::set<int> named(sequence.begin(), sequence.end());
  int next = yarns;
  for (auto it = named.lower_bound(yarns); it != named.end(); ++it, ++next)
    if (*it != next) return *it;
  return std::nullopt;
}

/// The order of a text, or why there is none, said in `typing`.
std::optional<std::vector<int>> taken(const std::string& text, int yarns, OrderText& typing) {
  typing.problem.clear();
  typing.wanted.clear();
  try {
    std::vector<int> sequence = yarnOrderFromText(text, kMaxKinds, kMaxSequence);
    const int most = *std::max_element(sequence.begin(), sequence.end());
    if (most < yarns) return sequence;
    const std::string next = yarnLetters(yarns);
    if (const auto far = beyondGap(sequence, yarns)) {
      typing.problem = fmt::format(words::order::yarnBeyondNext, yarnLetters(*far), next);
      return std::nullopt;
    }
    typing.problem = fmt::format(words::order::noSuchYarn, next);
    typing.wanted = std::move(sequence);
  } catch (const InputError& error) {
    typing.problem = error.what();
    typing.problem.front() = 'E';  // "expected ..."
    typing.problem += '.';
  }
  return std::nullopt;
}

/// How many ends or picks an order has, and how far they reach.
std::string lengthText(bool isWarp, size_t threads, double length_mm) {
  const char* const one = isWarp ? words::order::oneEnd : words::order::onePick;
  const char* const several = isWarp ? words::order::severalEnds : words::order::severalPicks;
  return fmt::format(fmt::runtime(threads == 1 ? one : several), threads, length_mm);
}

/// The field's name, and at the end of its line what the order comes to: a line of its own would push the stripes below
/// out of sight.
void lineAbove(Ui& ui, const RowText& text, const std::string& comesTo) {
  const std::string id = text.id + "_threads";
  ImGui::TextDisabled("%s", text.label);
  ImGui::SameLine(0, ui.px(12));
  std::string cut;
  const std::string shown = fitted(ui, id, comesTo.c_str(), ImGui::GetContentRegionAvail().x, cut);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(shown.c_str()).x);
  ImGui::TextColored(ui.theme.textQuiet, "%s", shown.c_str());
  ui.probe.recordItem(id);
  tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), cut.c_str());
}

/// What is wrong with the order that is typed, where something is, and the way out.
std::optional<Fabric> lineBelow(Ui& ui, const std::string& id, const Fabric& fabric, std::vector<int> Fabric::* system,
                                OrderText& typing) {
  ui.probe.fact(id + "_problem", typing.problem);
  if (typing.problem.empty()) return std::nullopt;
  std::optional<Fabric> edited;
  const float top = ImGui::GetCursorPosY(), height = ImGui::GetFrameHeight();
  const float offer = typing.wanted.empty() ? 0 : ui.px(104);
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(ui.theme.error, "%s", shortened(typing.problem, ImGui::GetContentRegionAvail().x - offer).c_str());
  ui.probe.recordItem(id + "_line");
  tooltipFor(ui, (id + "_line").c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), typing.problem.c_str());
  if (offer > 0) {
    const int last = *std::max_element(typing.wanted.begin(), typing.wanted.end());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - offer);
    const Word& add = words::order::addYarn;
    if (button(ui, (id + "_add").c_str(), add.label, offer, true, add.help)) {
      edited = fabric;
      while (static_cast<int>(edited->yarns.size()) <= last)
        edited = withYarnCopied(*edited, static_cast<int>(edited->yarns.size()) - 1);
      (*edited).*system = typing.sequence = typing.wanted;
      typing.problem.clear();
      typing.wanted.clear();
    }
  }
  ImGui::SetCursorPosY(top + height + ui.px(4));
  return edited;
}

}  // namespace

std::optional<Fabric> orderField(Ui& ui, const RowText& text, const Fabric& fabric, std::vector<int> Fabric::* system,
                                 double pitch_mm, OrderText& typing) {
  const std::vector<int>& sequence = fabric.*system;
  if (!typing.open && typing.sequence != sequence)
    typing = {false, false, yarnOrderText(sequence), sequence, typing.lines, {}, {}};
  const double length_mm = pitch_mm * static_cast<double>(sequence.size());
  lineAbove(ui, text, lengthText(system == &Fabric::warpSequence, sequence.size(), length_mm));
  const float width = ImGui::GetContentRegionAvail().x;
  Typing now{width - 2 * ImGui::GetStyle().FramePadding.x - ui.px(8), !typing.open};
  std::string shown = typing.text;
  const bool tooLong = shown.size() > kLongest;
  if (tooLong) shown = fmt::format(words::order::onlyCounted, sequence.size());
  breakLines(shown.data(), static_cast<int>(shown.size()), now.room);
  // An edge of stripes that is dragged writes another order: what stands below the field stays under the mouse.
  if (typing.open || !ImGui::IsAnyMouseDown())
    typing.lines = std::min(6.0f, static_cast<float>(1 + std::count(shown.begin(), shown.end(), '\n')));
  const ImVec2 size(width, typing.lines * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().FramePadding.y);
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size.x, min.y + size.y);
  ImGui::PushID(text.id.c_str());
  ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);
  const ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CtrlEnterForNewLine |
                                    ImGuiInputTextFlags_NoHorizontalScroll | ImGuiInputTextFlags_CallbackAlways |
                                    (tooLong ? ImGuiInputTextFlags_ReadOnly : 0);
  const bool entered = ImGui::InputTextMultiline("##text", &shown, size, flags, breakWhileTyped, &now);
  ImGui::PopItemFlag();
  ui.memory.tabOrder.pass(ImGui::GetItemID(), panelOfFields(), false);
  typing.open = ImGui::IsItemActive();
  const bool left = ImGui::IsItemDeactivated();
  ImGui::PopID();
  if (!typing.problem.empty())
    ImGui::GetWindowDrawList()->AddRect(min, max, packed(ui.theme.error), ImGui::GetStyle().FrameRounding);
  endRow(ui, text, min, max);
  std::optional<Fabric> edited;
  if (!tooLong) {
    std::replace(shown.begin(), shown.end(), '\n', ' ');
    const bool changed = shown != typing.text;
    if (changed) typing.text = shown;
    if ((entered || left) && (changed || typing.edited)) {
      typing.edited = false;
      if (auto order = taken(typing.text, static_cast<int>(fabric.yarns.size()), typing)) {
        typing.sequence = *order;
        if (*order != sequence) {
          edited = fabric;
          (*edited).*system = std::move(*order);
        }
      }
    } else if (changed) {
      typing.edited = true;
    }
  }
  auto added = lineBelow(ui, text.id, fabric, system, typing);
  return added ? std::move(added) : std::move(edited);
}

}  // namespace loomlight
