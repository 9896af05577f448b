#include <fmt/core.h>

#include <cmath>

#include "core/base/units.h"
#include "ui/draft/draft_drawing.h"

namespace loomlight {
namespace {

/// Millimetres between labels, so that they stand apart: 1, 2 or 5 times a power of ten of the unit, or for inches
/// halves of a power of two.
double labelStep_mm(double perPixel_mm, float least_px, bool inches) {
  const double unit_mm = inches ? kMmPerInch : 10.0, least = perPixel_mm * least_px / unit_mm;
  if (inches) return unit_mm * std::exp2(std::ceil(std::log2(least)));
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return unit_mm * factor * power;
  return unit_mm * 10 * power;
}

}  // namespace

void drawRuler(Ui& ui, const Fabric& fabric, const DraftFrame& frame, System along, bool inches, const Box& ruler) {
  // The warp runs along the picks, and is measured across them.
  const bool picks = along == System::warp;
  const double pitch_mm = picks ? fabric.weftPitch_mm() : fabric.warpPitch_mm();
  const float room = picks ? ruler.height() : ruler.width(), cell = picks ? frame.cellHeight() : frame.cell;
  const double first_mm = (picks ? frame.origin.y : frame.origin.x) * pitch_mm;
  const double last_mm = first_mm + room / cell * pitch_mm;
  const double step = labelStep_mm(pitch_mm / cell, ui.px(44), inches);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  draw.PushClipRect(ruler.min, ruler.max, true);
  const ImU32 ink = packed(ui.theme.textQuiet);
  constexpr int kTicks = 4;  // between labels
  for (auto i = static_cast<int64_t>(std::ceil(kTicks * first_mm / step));
       step * static_cast<double>(i) / kTicks <= last_mm; ++i) {
    const double mm = step * static_cast<double>(i) / kTicks;
    const float at = std::round(picks ? frame.y(mm / pitch_mm) : frame.x(mm / pitch_mm));
    const bool labelled = i % kTicks == 0;
    const float tick = ui.px(labelled ? 6 : 3);
    if (picks)
      draw.AddRectFilled(ImVec2(ruler.max.x - ui.px(2) - tick, at), ImVec2(ruler.max.x - ui.px(2), at + 1), ink);
    else
      draw.AddRectFilled(ImVec2(at, ruler.min.y + ui.px(2)), ImVec2(at + 1, ruler.min.y + ui.px(2) + tick), ink);
    if (!labelled) continue;
    const std::string label = fmt::format("{:.4g}", mm / (inches ? kMmPerInch : 10.0));
    const ImVec2 size = ImGui::CalcTextSize(label.c_str());
    if (picks && at - size.y - 1 < ruler.min.y) continue;  // half a number says another one
    if (picks)
      draw.AddText(ImVec2(ruler.min.x, at - size.y - 1), ink, label.c_str());
    else
      draw.AddText(ImVec2(at + ui.px(3), ruler.min.y + ui.px(3)), ink, label.c_str());
  }
  draw.PopClipRect();
  ImGui::PopFont();
}

}  // namespace loomlight
