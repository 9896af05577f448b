#include "ui/viewport/view_labels.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/viewport/pill.h"
#include "ui/widgets/fields.h"
#include "ui/words/viewport_words.h"

namespace loomlight {
namespace {

/// In which ways the picture is shown that are not those of every day.
std::string waysShown(const ViewportModel& model) {
  std::string ways;
  const auto add = [&ways](bool holds, const char* way) {
    if (holds) ways += (ways.empty() ? "" : words::viewport::between) + std::string(way);
  };
  add(model.plain, words::viewport::plain);
  add(model.denoised, words::viewport::denoised);
  add(model.proofed, words::viewport::asPrinted);
  add(model.warned, words::viewport::warned);
  return ways;
}

/// Labels from the top of the picture down, in lines.
class TopLabels {
 public:
  TopLabels(Ui& ui, ImVec2 min, ImVec2 max)
      : ui_(ui), edge_(ui.px(8)), left_(min.x + edge_), right_(max.x - edge_), top_(min.y + edge_), until_(left_) {}

  /// `along`: 0 at the left, 0.5 in the middle, 1 at the right. In the same line as the last where there is room.
  void add(const char* id, const std::string& text, float along, const ImVec4& colour) {
    const float room = right_ - left_;
    const ImVec2 size = pillSize(ui_, text, room);
    float x = left_ + along * (room - size.x);
    if (x < until_) {
      nextLine();
      x = left_ + along * (room - size.x);
    }
    pill(ui_, ImVec2(x, top_), text, colour, room);
    ui_.probe.record(id, ImVec2(x, top_), ImVec2(x + size.x, top_ + size.y));
    until_ = x + size.x + edge_;
    height_ = std::max(height_, size.y);
  }

 private:
  void nextLine() {
    top_ += height_ + ui_.px(4);
    until_ = left_;
    height_ = 0;
  }

  Ui& ui_;
  float edge_, left_, right_, top_;
  float until_;       ///< where the next one of the line can begin
  float height_ = 0;  ///< of the line
};

}  // namespace

void viewLabels(Ui& ui, const ViewportModel& model, const InsetView& inset, ImVec2 min, ImVec2 max) {
  const ImVec4 text = Theme::dark().text;
  const float edge = ui.px(8);
  if (model.building) {
    const float along = min.x + static_cast<float>(model.buildProgress) * (max.x - min.x);
    ImGui::GetWindowDrawList()->AddRectFilled(min, ImVec2(along, min.y + ui.px(3)), packed(ui.theme.accent));
  }
  if (!model.picture.texture) {
    const ImVec2 size = pillSize(ui, words::viewport::building);
    pill(ui, ImVec2(0.5f * (min.x + max.x - size.x), 0.5f * (min.y + max.y - size.y)), words::viewport::building, text);
  }
  const std::string ways = waysShown(model);
  ui.probe.fact("view.ways", ways);
  TopLabels top(ui, min, max);
  if (!model.flat.empty()) top.add("view.flat", model.flat, 0, text);
  if (inset.on && !inset.placed) top.add("view.hint", words::lens::dragRectangle, 0.5f, text);
  if (!ways.empty()) top.add("view.ways", ways, 1, text);
  if (!model.error.empty()) top.add("view.error", model.error, 0, Theme::dark().warning);
  std::string under;
  if (model.under) {
    under = fmt::format(words::viewport::crossing, model.under->end + 1, model.under->pick + 1, model.underYarn);
    const std::string shown = shortened(under, max.x - min.x - 4 * edge);
    pill(ui, ImVec2(min.x + edge, max.y - edge - pillSize(ui, shown).y), shown, text);
  }
  ui.probe.fact("view.under", under);
}

}  // namespace loomlight
