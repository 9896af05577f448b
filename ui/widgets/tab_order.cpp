#include "ui/widgets/tab_order.h"

#include <algorithm>
#include <utility>

namespace loomlight {
namespace {

constexpr int kFramesToArrive = 2;  // one for the text that is left and taken, one to open

}  // namespace

void TabOrder::pass(ImGuiID field, ImGuiID panel, bool isNumber) {
  if (const int now = ImGui::GetFrameCount(); now != frame_) {
    frame_ = now;
    drawn_ = std::exchange(drawing_, {});
    // The field gone to would have been drawn by now: its page was left, and must not open it when it comes back.
    if (now > wantedIn_ + kFramesToArrive) stay();
  }
  drawing_.push_back({field, panel, isNumber});
}

void TabOrder::go(int step, std::optional<ImGuiID> panel) {
  // Asked before the first field of a frame is drawn, and so of the frame before.
  const std::vector<Stop>& stops = frame_ == ImGui::GetFrameCount() ? drawn_ : drawing_;
  auto from = std::find_if(stops.begin(), stops.end(), [&](const Stop& stop) {
    return stop.field == standing_ && (!panel || stop.panel == *panel);
  });
  const bool stands = from != stops.end();
  if (!panel && stands) panel = from->panel;
  if (!panel) {
    const auto last = std::find_if(stops.rbegin(), stops.rend(), [](const Stop& stop) { return stop.isNumber; });
    if (last == stops.rend()) return;
    panel = last->panel;
  }
  const auto count = static_cast<int>(stops.size());
  int at = stands ? static_cast<int>(from - stops.begin()) : step > 0 ? -1 : count;
  for (int looked = 0; looked < count; ++looked) {
    at = (at + step + count) % count;
    const Stop& stop = stops[static_cast<size_t>(at)];
    if (!stop.isNumber || stop.panel != *panel) continue;
    wanted_ = stop.field;
    wantedIn_ = ImGui::GetFrameCount();
    return;
  }
}

bool TabOrder::arrive(ImGuiID field) {
  if (wanted_ != field) return false;
  wanted_ = 0;
  standOn(field, true);
  return true;
}

}  // namespace loomlight
