#include "ui/status_bar.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/model/glossary.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/number_text.h"
#include "ui/words/status_words.h"

namespace loomlight {
namespace {

/// Returns where it ends.
float figure(Ui& ui, const char* id, float x, const std::string& text, const char* tooltip, const ImVec4& colour) {
  const ImVec2 window = ImGui::GetWindowPos();
  const float y = window.y + 0.5f * (ImGui::GetWindowHeight() - ImGui::GetFontSize());
  const ImVec2 at(window.x + x, y);
  ImGui::GetWindowDrawList()->AddText(at, packed(colour), text.c_str());
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 max(at.x + size.x, at.y + size.y);
  ui.probe.record(id, at, max);
  ui.probe.fact(id, text);
  tooltipFor(ui, id, at, max, tooltip);
  return x + size.x;
}

std::string floatsText(const StatusModel& model) {
  const std::string longest = model.unboundYarns > 0
                                  ? std::string(words::status::endlessFloat)
                                  : fmt::format(words::status::longestFloat, model.longestFloat, model.longestFloat_mm);
  return model.longFloats == 0 ? longest
                               : fmt::format(words::status::longFloats, longest, model.longFloats, model.longFloat_mm);
}

}  // namespace

void statusBar(Ui& ui, const StatusModel& model) {
  ImGui::PushFont(ui.fonts.small);
  const ImVec4& quiet = ui.theme.textQuiet;
  const float width = ImGui::GetWindowWidth();
  const float x = ui.px(16);
  // The places are reserved, so that nothing moves. In a narrow window figures end before what the workers say begins.
  const float right = width - ui.px(model.background.empty() && model.lamp.empty() ? 338 : 458);
  constexpr float kFigures = 520;  // the room of all of them
  const bool giveWay = model.isUrgent && x + ui.px(kFigures) + ImGui::CalcTextSize(model.warning.c_str()).x > right;
  float end = x;  // of what is said of the cloth
  const auto clothFigure = [&](const char* id, float place, const std::string& text, const char* tooltip) {
    const float from = x + ui.px(place);
    if (model.figuresKnown && !giveWay && from + ImGui::CalcTextSize(text.c_str()).x < right)
      end = figure(ui, id, from, text, tooltip, quiet);
  };
  clothFigure("status.mass", 0, fmt::format("{:.0f} g/m\xC2\xB2", model.arealMass_g_m2), words::status::massHelp);
  clothFigure("status.cover", 88, fmt::format(words::status::cover, model.coverPercent), words::status::coverHelp);
  clothFigure("status.thickness", 184, fmt::format(words::status::thickness, model.thickness_mm),
              words::thickness.help);
  clothFigure("status.float", 304, floatsText(model), words::status::floatHelp);
  const std::string more = model.moreWarnings > 0 ? fmt::format("  (+{})", model.moreWarnings) : std::string();
  const float left = giveWay ? x : std::max(x + ui.px(kFigures), end + ui.px(16));
  const float room = right - left - ImGui::CalcTextSize(more.c_str()).x;
  if (!model.warning.empty() && room > ui.px(40))
    figure(ui, "status.warning", left, shortened(model.warning, room) + more, model.warning.c_str(), ui.theme.warning);
  if (!model.background.empty())
    figure(ui, "status.background", width - ui.px(442), model.background, words::status::visibilityHelp, quiet);
  else if (!model.lamp.empty())
    figure(ui, "status.lamp", width - ui.px(442), model.lamp, words::status::lampHelp, quiet);
  figure(ui, "status.work", width - ui.px(322), model.work, words::status::workHelp, quiet);
  figure(ui, "status.samples", width - ui.px(162), sampleText(model.samples), words::status::samplesHelp, quiet);
  figure(ui, "status.seconds", width - ui.px(66), fmt::format("{:.1f} s", model.seconds), words::status::secondsHelp,
         quiet);
  ImGui::PopFont();
}

}  // namespace loomlight
