#include "ui/draft/stripe_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/model/validate.h"
#include "core/fabric/weave/thread_sequence.h"
#include "core/fabric/yarn/yarn_name.h"
#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

constexpr size_t kMostRows = 48;  // a jacquard's thousands are set in the order's text, or in the bars

/// A field of a row, at its place.
template <class Field>
bool cell(const std::string& id, float x, float width, const Field& field) {
  ImGui::SameLine(x);
  ImGui::BeginChild(id.c_str(), ImVec2(width, ImGui::GetFrameHeight()), false, ImGuiWindowFlags_NoScrollbar);
  const bool changed = field();
  ImGui::EndChild();
  return changed;
}

}  // namespace

std::optional<std::vector<int>> stripeTable(Ui& ui, const std::vector<int>& sequence,
                                            const std::vector<ImVec4>& yarnColours, double pitch_mm) {
  std::vector<Stripe> stripes = stripesOf(sequence);
  const int others = static_cast<int>(sequence.size());
  const float all = ImGui::GetContentRegionAvail().x, swatch = ui.px(24), letter = ui.px(28), gap = ui.px(8);
  const float left = ImGui::GetCursorPosX(), first = left + swatch + letter;
  const float width = 0.5f * (all - swatch - letter - gap);
  bool changed = false;
  for (size_t i = 0; i < std::min(stripes.size(), kMostRows); ++i) {
    Stripe& stripe = stripes[i];
    const int room = kMaxSequence - others + stripe.threads;
    const std::string row = fmt::format("order.stripe_{}", i);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, at.y + ui.px(4)),
                                              ImVec2(at.x + swatch, at.y + ImGui::GetFrameHeight() - ui.px(4)),
                                              packed(yarnColours[static_cast<size_t>(stripe.yarn)]), ui.px(2));
    ImGui::SetCursorPosX(left + swatch + ui.px(6));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(yarnLetters(stripe.yarn).c_str());
    changed |= cell(row + "t", first, width, [&] {
      return wholeNumberField(ui, {row + "_threads", "", "Threads of this stripe", true}, "", 1, room, stripe.threads);
    });
    changed |= cell(row + "w", first + width + gap, width, [&] {
      NumberStyle style;
      style.unit = "cm";
      style.min = 0.1 * pitch_mm;
      style.max = 0.1 * pitch_mm * room;
      double width_cm = 0.1 * pitch_mm * stripe.threads;
      if (!numberField(ui, {row + "_cm", "", "Width of this stripe, to whole threads", true}, style, width_cm))
        return false;
      const int before = stripe.threads;
      stripe.threads = std::clamp(static_cast<int>(std::lround(10 * width_cm / pitch_mm)), 1, room);
      return stripe.threads != before;
    });
  }
  if (stripes.size() > kMostRows) hint(ui, fmt::format("and {} more", stripes.size() - kMostRows));
  if (!changed) return std::nullopt;
  return sequenceOf(stripes);
}

}  // namespace loomlight
