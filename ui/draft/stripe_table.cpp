#include "ui/draft/stripe_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/model/glossary.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/yarn/yarn_name.h"
#include "ui/widgets/fields.h"
#include "ui/words/stripe_words.h"

namespace loomlight {
namespace {

constexpr size_t kMostRows = 48;  // a jacquard's thousands are set in the order's text, or in the bars
constexpr float kStripeBar = 24, kSwatch = 24, kLetter = 26, kButton = 24, kStripeGap = 6;  // at scale 1

int widthOf(const std::vector<Stripe>& stripes) {
  int width = 0;
  for (const Stripe& stripe : stripes) width += stripe.width;
  return width;
}

/// The edge between stripes that the mouse may take, as far from it as a finger's width at most; -1: none.
int edgeUnder(const Ui& ui, const std::vector<Stripe>& stripes, float x, float perYarn) {
  int nearest = -1, width = 0;
  float closest = ui.px(6);
  for (size_t i = 0; i < stripes.size(); ++i) {
    width += stripes[i].width;
    const float away = std::abs(x - perYarn * static_cast<float>(width));
    if (away > closest) continue;
    closest = away;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

/// Moves the edge after a stripe to an end or pick, as far as every stripe keeps one and the order has room.
void moveEdge(std::vector<Stripe>& stripes, int edge, int to) {
  const auto i = static_cast<size_t>(edge);
  int begin = 0;
  for (size_t k = 0; k < i; ++k) begin += stripes[k].width;
  if (i + 1 == stripes.size()) {
    stripes[i].width = std::clamp(to - begin, 1, kMaxSequence - begin);
    return;
  }
  const int both = stripes[i].width + stripes[i + 1].width;
  stripes[i].width = std::clamp(to - begin, 1, both - 1);
  stripes[i + 1].width = both - stripes[i].width;
}

void drawBar(Ui& ui, const StripedSystem& system, const std::vector<Stripe>& stripes, float perYarn, ImVec2 min,
             ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(min, max, true);
  draw.AddRectFilled(min, max, packed(ui.theme.field));
  int at = 0;
  for (size_t i = 0; i < stripes.size(); ++i) {
    const float begin = min.x + perYarn * static_cast<float>(at);
    at += stripes[i].width;
    const float end = min.x + perYarn * static_cast<float>(at);
    draw.AddRectFilled(ImVec2(begin, min.y), ImVec2(end, max.y),
                       packed(system.yarnColours[static_cast<size_t>(stripes[i].yarn)]));
    // Neighbours of one yarn are told apart, where there is room for it.
    if (end - begin > ui.px(4)) draw.AddLine(ImVec2(end, min.y), ImVec2(end, max.y), packed(ui.theme.panel), ui.px(1));
    if (ui.probe.watching())
      ui.probe.record(fmt::format("order.edge_{}", i), ImVec2(end - ui.px(2), min.y), ImVec2(end + ui.px(2), max.y));
  }
  draw.AddRect(min, max, packed(ui.theme.text, 0.18f));
  draw.PopClipRect();
}

/// A field of a row, at its place.
template <class Field>
bool cell(const std::string& id, float x, float width, const Field& field) {
  ImGui::SameLine(x);
  ImGui::BeginChild(id.c_str(), ImVec2(width, ImGui::GetFrameHeight()), false, ImGuiWindowFlags_NoScrollbar);
  const bool changed = field();
  ImGui::EndChild();
  return changed;
}

/// Where the columns of the table are.
struct Columns {
  explicit Columns(const Ui& ui)
      : left(ImGui::GetCursorPosX()),
        swatch(ui.px(kSwatch)),
        first(left + swatch + ui.px(kLetter)),
        width(0.5f * (ImGui::GetContentRegionAvail().x - swatch - ui.px(kLetter + 2 * kButton + 3 * kStripeGap))),
        second(first + width + ui.px(kStripeGap)),
        add(second + width + ui.px(kStripeGap)),
        remove(add + ui.px(kButton + kStripeGap)) {}
  float left, swatch, first, width, second, add, remove;
};

/// Which yarn a stripe is of: a swatch that opens the others.
bool colourCell(Ui& ui, const std::string& row, const Columns& columns, const StripedSystem& system, Stripe& stripe) {
  const auto colourOf = [&](int yarn) { return system.yarnColours[static_cast<size_t>(yarn)]; };
  const auto nameOf = [&](int yarn) { return yarnLetters(yarn) + "   " + system.yarnNames[static_cast<size_t>(yarn)]; };
  bool changed = false;
  const std::string about = nameOf(stripe.yarn) + "\n" + words::stripeColour.help;
  if (swatch(ui, (row + "_colour").c_str(), colourOf(stripe.yarn), columns.swatch, false, about.c_str()))
    ImGui::OpenPopup((row + "_yarns").c_str());
  if (ImGui::BeginPopup((row + "_yarns").c_str())) {
    constexpr int kPerLine = 8;
    for (int yarn = 0; yarn < static_cast<int>(system.yarnColours.size()); ++yarn) {
      if (yarn % kPerLine != 0) ImGui::SameLine(0, ui.px(4));
      const std::string id = fmt::format("{}_yarn_{}", row, yarn);
      if (!swatch(ui, id.c_str(), colourOf(yarn), ui.px(28), yarn == stripe.yarn, nameOf(yarn).c_str())) continue;
      changed = yarn != stripe.yarn;
      stripe.yarn = yarn;
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  ImGui::SameLine(columns.left + columns.swatch + ui.px(kStripeGap));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(yarnLetters(stripe.yarn).c_str());
  return changed;
}

bool widthCell(Ui& ui, const std::string& row, double pitch_mm, int room, int& width) {
  NumberStyle style;
  style.unit = "cm";
  style.min = 0.1 * pitch_mm;
  style.max = 0.1 * pitch_mm * room;
  double width_cm = 0.1 * pitch_mm * width;
  if (!numberField(ui, {row + "_cm", "", words::stripe::widthHelp, true}, style, width_cm)) return false;
  const int before = width;
  width = std::clamp(static_cast<int>(std::lround(10 * width_cm / pitch_mm)), 1, room);
  return width != before;
}

}  // namespace

void StripeRows::follow(const std::vector<int>& sequence) {
  if (sequenceOf(stripes) == sequence) return;
  stripes = stripesOf(sequence);
  dragged = -1;
}

std::optional<std::vector<int>> stripeBar(Ui& ui, const StripedSystem& system, StripeRows& rows) {
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ui.px(kStripeBar)), min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImGui::InvisibleButton("order.bar", size);
  ui.probe.recordItem("order.bar");
  // While an edge is dragged an end keeps its width: the last edge would run away under the mouse.
  const float perYarn =
      rows.dragged >= 0 ? rows.perYarn : size.x / static_cast<float>(std::max(1, widthOf(rows.stripes)));
  const float x = ImGui::GetIO().MousePos.x - min.x;
  const int under = edgeUnder(ui, rows.stripes, x, perYarn);
  if (ImGui::IsItemActivated()) {
    rows.dragged = under;
    rows.perYarn = perYarn;
  }
  if (!ImGui::IsItemActive()) rows.dragged = -1;
  if (rows.dragged >= 0 || (under >= 0 && ImGui::IsItemHovered())) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  std::optional<std::vector<int>> edited;
  if (rows.dragged >= 0) {
    const std::vector<Stripe> before = rows.stripes;
    moveEdge(rows.stripes, rows.dragged, static_cast<int>(std::lround(x / perYarn)));
    if (rows.stripes != before) edited = sequenceOf(rows.stripes);
  }
  drawBar(ui, system, rows.stripes, perYarn, min, max);
  if (rows.dragged < 0) tooltipFor(ui, "order.bar", min, max, words::stripeBar.help);
  return edited;
}

std::optional<std::vector<int>> stripeTable(Ui& ui, const StripedSystem& system, StripeRows& rows) {
  const Columns columns(ui);
  const int all = widthOf(rows.stripes);
  const int yarns = static_cast<int>(system.yarnColours.size());
  const float side = ui.px(kButton);
  bool changed = false;
  std::optional<size_t> added, removed;
  for (size_t i = 0; i < std::min(rows.stripes.size(), kMostRows); ++i) {
    Stripe& stripe = rows.stripes[i];
    const int room = kMaxSequence - all + stripe.width;
    const std::string row = fmt::format("order.stripe_{}", i);
    changed |= colourCell(ui, row, columns, system, stripe);
    changed |= cell(row + "t", columns.first, columns.width, [&] {
      return wholeNumberField(ui, {row + "_threads", "", words::stripe::threadsHelp, true}, system.several, 1, room,
                              stripe.width, system.one);
    });
    changed |= cell(row + "w", columns.second, columns.width,
                    [&] { return widthCell(ui, row, system.pitch_mm, room, stripe.width); });
    ImGui::SameLine(columns.add);
    const Word &add = words::addStripe, &remove = words::removeStripe;
    if (button(ui, (row + "_add").c_str(), add.label, side, stripe.width <= kMaxSequence - all, add.help)) added = i;
    ImGui::SameLine(columns.remove);
    if (button(ui, (row + "_remove").c_str(), remove.label, side, rows.stripes.size() > 1, remove.help)) removed = i;
  }
  if (rows.stripes.size() > kMostRows) hint(ui, fmt::format(words::stripe::more, rows.stripes.size() - kMostRows));
  if (added) {
    const Stripe& like = rows.stripes[*added];
    const Stripe another{(like.yarn + 1) % yarns, like.width};
    rows.stripes.insert(rows.stripes.begin() + static_cast<ptrdiff_t>(*added) + 1, another);
  } else if (removed) {
    rows.stripes.erase(rows.stripes.begin() + static_cast<ptrdiff_t>(*removed));
  }
  if (!changed && !added && !removed) return std::nullopt;
  return sequenceOf(rows.stripes);
}

}  // namespace loomlight
