#include "ui/viewport/booth_overlay.h"

#include <cmath>
#include <string>

#include "core/fabric/model/booth_lamps.h"
#include "core/fabric/model/choice_names.h"
#include "ui/viewport/pill.h"
#include "ui/widgets/choices.h"

namespace loomlight {
namespace {

/// Where the quarters meet: of an odd pixel the first has one more.
ImVec2 middleOf(ImVec2 min, ImVec2 max) {
  return ImVec2(min.x + std::ceil(0.5f * (max.x - min.x)), min.y + std::ceil(0.5f * (max.y - min.y)));
}

}  // namespace

void boothOverlay(Ui& ui, ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 middle = middleOf(min, max);
  const float half = ui.px(2), edge = ui.px(8);
  const ImU32 surround = packed(ui.theme.surround);
  draw.AddRectFilled(ImVec2(middle.x - half, min.y), ImVec2(middle.x + half, max.y), surround);
  draw.AddRectFilled(ImVec2(min.x, middle.y - half), ImVec2(max.x, middle.y + half), surround);
  // The labels meet in the middle, so that one look reads them all; the corners of the picture say other things.
  for (size_t i = 0; i < kBoothLamps.size(); ++i) {
    const bool right = i % 2 == 1, low = i / 2 == 1;
    const std::string name = lampLabel(kBoothLamps[i]), id = std::string("booth.") + choiceName(kBoothLamps[i]);
    const ImVec2 size = pillSize(ui, name);
    pill(ui,
         ImVec2(right ? middle.x + edge : middle.x - edge - size.x, low ? middle.y + edge : middle.y - edge - size.y),
         name, Theme::dark().text);
    ui.probe.record(id, ImVec2(right ? middle.x : min.x, low ? middle.y : min.y),
                    ImVec2(right ? max.x : middle.x, low ? max.y : middle.y));
  }
}

ImVec2 fromMiddle(ImVec2 point, ImVec2 min, ImVec2 max, bool divided) {
  ImVec2 middle(0.5f * (min.x + max.x), 0.5f * (min.y + max.y));
  if (divided) {
    middle.x += (point.x < middle.x ? -0.25f : 0.25f) * (max.x - min.x);
    middle.y += (point.y < middle.y ? -0.25f : 0.25f) * (max.y - min.y);
  }
  return ImVec2(point.x - middle.x, point.y - middle.y);
}

}  // namespace loomlight
