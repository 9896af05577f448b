#include "ui/inspector/yarn_section.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/words/yarn_words.h"

namespace loomlight {
namespace {

/// The longest of 1, 2, 5, 10... micrometres that is no longer than this.
double roundLength_um(double longest_um) {
  const double decade = std::pow(10.0, std::floor(std::log10(longest_um)));
  const double digits = longest_um / decade;
  return decade * (digits >= 5 ? 5 : digits >= 2 ? 2 : 1);
}

void drawScaleBar(Ui& ui, ImVec2 max, double pixelsPerMm) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const double length_um = roundLength_um(1000.0 * ui.px(72) / pixelsPerMm);
  const float length = static_cast<float>(length_um * 1e-3 * pixelsPerMm);
  const std::string text =
      length_um >= 1000 ? fmt::format("{:g} mm", length_um / 1000) : fmt::format("{:g} \xC2\xB5m", length_um);
  const float y = max.y - ui.px(8), x = max.x - ui.px(10);
  draw.AddLine(ImVec2(x - length, y), ImVec2(x, y), packed(ui.theme.textQuiet), ui.px(1.5f));
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw.AddText(ImVec2(x - size.x, y - size.y - ui.px(3)), packed(ui.theme.textQuiet), text.c_str());
  ImGui::PopFont();
}

/// Neighbouring fibres of one colour would run together: a darker rim keeps each one apart, or a lighter one where
/// nothing darker would show.
ImVec4 rimOf(const ImVec4& colour) {
  const bool dark = std::max({colour.x, colour.y, colour.z}) < 0.35f;
  auto shade = [&](float value) { return dark ? value + 0.3f : 0.55f * value; };
  return ImVec4(shade(colour.x), shade(colour.y), shade(colour.z), 1.0f);
}

}  // namespace

void drawYarnSection(Ui& ui, const YarnSection& section, const YarnFibreColours& colours, ImVec2 size) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImGui::Dummy(size);
  ui.probe.recordItem("yarn.section");
  draw.AddRectFilled(min, max, packed(ui.theme.field), ui.px(4));
  if (section.points.empty() || section.halfWidth_mm <= 0) return;

  const double room = 0.8;                 // plies stand out of the outline
  const float bottom = max.y - ui.px(26);  // the scale bar stands below it
  const double pixelsPerMm =
      room * 0.5 * std::min((max.x - min.x) / section.halfWidth_mm, (bottom - min.y) / section.halfHeight_mm);
  const ImVec2 centre(0.5f * (min.x + max.x), 0.5f * (min.y + bottom));
  const float radius = std::max(0.75f, static_cast<float>(section.fibreRadius_mm * pixelsPerMm));
  const int segments = radius < 3 ? 6 : radius < 8 ? 12 : 24;
  draw.PushClipRect(min, max, true);
  for (const YarnSection::Point& point : section.points) {
    const ImVec2 at(centre.x + static_cast<float>(point.at_mm.x * pixelsPerMm),
                    centre.y - static_cast<float>(point.at_mm.y * pixelsPerMm));
    const ImVec4& fibreColour = point.second ? colours.second : colours.first;
    draw.AddCircleFilled(at, radius, packed(rimOf(fibreColour), point.hair ? 0.5f : 1.0f), segments);
    if (radius > 1.5f)
      draw.AddCircleFilled(at, radius - std::max(0.75f, 0.12f * radius), packed(fibreColour, point.hair ? 0.5f : 1.0f),
                           segments);
  }
  draw.PopClipRect();
  drawScaleBar(ui, max, pixelsPerMm);
}

void drawYarnCloseUp(Ui& ui, ImTextureID picture, ImVec2 size) {
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size.x, min.y + size.y);
  ImGui::Dummy(size);
  ui.probe.recordItem("yarn.close_up");
  ui.probe.fact("yarn.close_up", picture ? "there" : "none");
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, packed(ui.theme.field), ui.px(4));
  // The picture keeps its proportions, and loses what does not fit.
  const float scale = std::max(size.x / kCloseUpWidth, size.y / kCloseUpHeight);
  const float u = 0.5f * size.x / (kCloseUpWidth * scale), v = 0.5f * size.y / (kCloseUpHeight * scale);
  if (picture)
    draw.AddImageRounded(picture, min, max, ImVec2(0.5f - u, 0.5f - v), ImVec2(0.5f + u, 0.5f + v), IM_COL32_WHITE,
                         ui.px(4));
  tooltipFor(ui, "yarn.close_up", min, max, words::yarnPage::closeUp);
}

}  // namespace loomlight
