#include "ui/dialogs/file_preview.h"

#include <algorithm>

#include "ui/widgets/fields.h"
#include "ui/words/file_words.h"

namespace loomlight {

void drawFilePreview(Ui& ui, const FilePreview& preview, float width, float height) {
  ImGui::BeginChild("preview", ImVec2(width, height));
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  constexpr float kLines = 5;
  const float left = height - kLines * (ui.fonts.small->FontSize + ImGui::GetStyle().ItemSpacing.y);
  const float high = left < ui.px(64) ? 0 : std::min(width, left);
  draw.AddRectFilled(min, ImVec2(min.x + width, min.y + high), packed(ui.theme.field), ui.px(4));
  if (preview.picture && high > 0) {
    const float scale = std::min(width / preview.size.x, high / preview.size.y);
    const ImVec2 size(scale * preview.size.x, scale * preview.size.y);
    const ImVec2 corner(min.x + 0.5f * (width - size.x), min.y + 0.5f * (high - size.y));
    draw.AddImage(preview.picture, corner, ImVec2(corner.x + size.x, corner.y + size.y));
  }
  ImGui::Dummy(ImVec2(width, high + ui.px(4)));
  for (const std::string& line : preview.lines) hint(ui, line);
  if (preview.isComing) hint(ui, words::files::isLookedInto);
  ImGui::EndChild();
  std::string all;
  for (const std::string& line : preview.lines) all += line + "\n";
  ui.probe.fact("browser.preview", preview.picture ? "picture" : "none");
  ui.probe.fact("browser.about", all);
}

}  // namespace loomlight
