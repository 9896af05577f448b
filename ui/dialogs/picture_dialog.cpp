#include "ui/dialogs/picture_dialog.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/menu_words.h"
#include "ui/words/picture_words.h"

namespace loomlight {
namespace {

constexpr int kMostColours = 16, kMostFirstEnds = 1200;
constexpr int kWarpOver = 0, kWeftOver = 1, kFirstShade = 2, kShades = 7;

/// Uncut areas, the shades between weft and warp, and all that the palette of the draft offers.
std::vector<Structure> assignable() {
  std::vector<Structure> structures{{words::picture::warpOver, Weave(std::vector<Weave::Row>{{1}})},
                                    {words::menu::weftOver.label, Weave(std::vector<Weave::Row>{{0}})}};
  for (int raised = 1; raised <= kShades; ++raised)
    structures.push_back({fmt::format(words::picture::shadedSatin, raised), shadedSatin(8, 3, raised)});
  for (Structure& structure : structurePalette()) structures.push_back(std::move(structure));
  return structures;
}

ImU32 displayed(const Rgb8& c) {
  return IM_COL32(c[0], c[1], c[2], 255);
}

}  // namespace

void PictureDialog::await(std::string name) {
  name_ = std::move(name);
  source_.reset();
  weaving_ = closing_ = false;
  open_ = opening_ = true;
}

void PictureDialog::show(std::shared_ptr<const PictureSource> source, double aspect,
                         const std::optional<CellRect>& selection) {
  source_ = std::move(source);
  selection_ = selection;
  fillsSelection_ = selection.has_value();
  const Raster& raster = source_->raster;
  aspect_ = aspect;
  structures_ = assignable();
  // A drawing in two colours is point paper: a crossing for each pixel.
  const size_t few = source_->colours.few.size();
  const bool isPaper = few == 1 || few == 2;
  colours_ = isPaper ? 2 : 4;
  ends_ = isPaper ? raster.width : std::min(raster.width, kMostFirstEnds);
  picks_ = isPaper ? raster.height : proportionalPicks();
  reducePalette();
  if (isPaper && preview_.palette.size() == 2) assigned_ = {kWarpOver, kWeftOver};
}

int PictureDialog::proportionalPicks() const {
  const double picks = ends_ / aspect_ * source_->raster.height / source_->raster.width;
  return static_cast<int>(std::lround(std::clamp(picks, 1.0, static_cast<double>(Weave::kMaxSide))));
}

void PictureDialog::reducePalette() {
  preview_ = reduced(source_->small, paletteOf(source_->colours, colours_));
  changed_ = true;
  assigned_.clear();
  mergedInto_.resize(preview_.palette.size());
  std::iota(mergedInto_.begin(), mergedInto_.end(), size_t{0});
  const int last = std::max(1, static_cast<int>(preview_.palette.size()) - 1);
  for (int i = 0; i < static_cast<int>(preview_.palette.size()); ++i)
    assigned_.push_back(kFirstShade + (kShades - 1) * (last - i) / last);
}

/// The picture in its colours, those that are woven alike in one.
void PictureDialog::drawColours(float size) const {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImGui::Dummy(ImVec2(size, size));
  const float pixel = size / static_cast<float>(std::max(preview_.width, preview_.height));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (int y = 0; y < preview_.height; ++y)
    for (int x = 0; x < preview_.width;) {
      const uint8_t* row = &preview_.colourOf[static_cast<size_t>(y) * static_cast<size_t>(preview_.width)];
      int end = x + 1;
      while (end < preview_.width && mergedInto_[row[end]] == mergedInto_[row[x]]) ++end;
      draw.AddRectFilled(ImVec2(min.x + pixel * static_cast<float>(x), min.y + pixel * static_cast<float>(y)),
                         ImVec2(min.x + pixel * static_cast<float>(end), min.y + pixel * static_cast<float>(y + 1)),
                         displayed(preview_.palette[mergedInto_[row[x]]]));
      x = end;
    }
}

void PictureDialog::drawPreview(Ui& ui, ImTextureID woven, float size) {
  ImGui::BeginGroup();
  ImGui::BeginChild("picture.what", ImVec2(size, ImGui::GetFrameHeight()));
  segmentField(ui, {"picture.shown", "", words::picture::shownHelp, true}, words::picture::shownAs, showsColours_);
  ImGui::EndChild();
  if (showsColours_) {
    drawColours(size);
  } else {
    const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size, min.y + size);
    ImGui::Dummy(ImVec2(size, size));
    if (woven)
      ImGui::GetWindowDrawList()->AddImage(woven, min, max);
    else
      ImGui::GetWindowDrawList()->AddRectFilled(min, max, packed(ui.theme.surround));
  }
  ui.probe.recordItem("picture.preview");
  ImGui::EndGroup();
}

/// How large it is woven: as the selection, or as many threads as are wanted.
void PictureDialog::targetRows(Ui& ui) {
  if (selection_) {
    int chosen = fillsSelection_ ? 0 : 1;
    if (segmentField(ui, {"picture.into", words::picture::into}, words::picture::intoNames, chosen)) {
      fillsSelection_ = chosen == 0;
      changed_ = true;
    }
  }
  if (fillsSelection_) {
    readout(ui, {"picture.selection", words::picture::selection},
            fmt::format("{} \xC3\x97 {}", selection_->ends, selection_->picks));
    return;
  }
  changed_ |= wholeNumberField(ui, {"picture.ends", words::picture::ends}, "", 1, Weave::kMaxSide, ends_);
  changed_ |= wholeNumberField(ui, {"picture.picks", words::picture::picks}, "", 1, Weave::kMaxSide, picks_);
  if (button(ui, "picture.proportions", words::picture::proportions.label, 0, true, words::picture::proportions.help)) {
    picks_ = proportionalPicks();
    changed_ = true;
  }
}

void PictureDialog::drawFields(Ui& ui) {
  hint(ui, fmt::format(words::picture::about, name_, source_->raster.width, source_->raster.height));
  targetRows(ui);
  if (wholeNumberField(ui, {"picture.colours", words::picture::colours}, "", 1, kMostColours, colours_))
    reducePalette();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  std::vector<const char*> names;
  for (const Structure& structure : structures_) names.push_back(structure.name.c_str());
  for (size_t i = 0; i < preview_.palette.size(); ++i)
    if (mergedInto_[i] == i) colourRow(ui, i, names);
  hint(ui, words::picture::dragToMerge);
}

/// Both are woven alike from now on, and shown as one.
void PictureDialog::merge(size_t colour, size_t into) {
  std::replace(mergedInto_.begin(), mergedInto_.end(), colour, into);
  changed_ = true;
}

void PictureDialog::colourRow(Ui& ui, size_t colour, const std::vector<const char*>& names) {
  double share = 0;
  for (size_t i = 0; i < mergedInto_.size(); ++i)
    if (mergedInto_[i] == colour) share += preview_.shares[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  const std::string label = fmt::format("         {:.0f} %", 100 * share);
  changed_ |=
      choiceField(ui, {fmt::format("picture.structure_{}", colour), label.c_str(), words::picture::structureHelp},
                  names, assigned_[colour]);
  const ImVec2 after = ImGui::GetCursorPos();
  const ImVec2 min(at.x, at.y + ui.px(2)), max(at.x + ui.px(24), at.y + height - ui.px(2));
  ImGui::SetCursorScreenPos(min);
  const std::string id = fmt::format("picture.colour_{}", colour);
  ImGui::InvisibleButton(id.c_str(), ImVec2(max.x - min.x, max.y - min.y));
  ui.probe.recordItem(id);
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, displayed(preview_.palette[colour]), ui.px(3));
  constexpr const char* kPayload = "picture_colour";
  if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoPreviewTooltip)) {
    ImGui::SetDragDropPayload(kPayload, &colour, sizeof colour);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImGui::GetForegroundDrawList()->AddRectFilled(ImVec2(mouse.x - ui.px(8), mouse.y - ui.px(8)),
                                                  ImVec2(mouse.x + ui.px(8), mouse.y + ui.px(8)),
                                                  displayed(preview_.palette[colour]), ui.px(3));
    ImGui::EndDragDropSource();
  }
  if (ImGui::BeginDragDropTarget()) {
    const ImGuiPayload* const dropped = ImGui::AcceptDragDropPayload(kPayload);
    if (dropped && dropped->DataSize == sizeof colour) {
      size_t other = 0;
      std::memcpy(&other, dropped->Data, sizeof other);
      if (other != colour && other < mergedInto_.size()) merge(other, colour);
    }
    ImGui::EndDragDropTarget();
  }
  ImGui::SetCursorPos(after);
}

PictureOrder PictureDialog::order() const {
  PictureOrder order{source_, ends_, picks_, preview_.palette, {}, {}};
  if (fillsSelection_) {
    order.into = selection_;
    order.ends = selection_->ends;
    order.picks = selection_->picks;
  }
  for (const size_t colour : mergedInto_)
    order.structures.push_back(structures_[static_cast<size_t>(assigned_[colour])].weave);
  return order;
}

std::optional<PictureOrder> PictureDialog::takeChanged() {
  if (!open_ || !source_ || !std::exchange(changed_, false)) return std::nullopt;
  return order();
}

std::optional<PictureOrder> PictureDialog::draw(Ui& ui, ImTextureID woven) {
  if (!open_ || !beginModal(ui, words::picture::title, ImVec2(ui.px(720), 0), open_, opening_)) return std::nullopt;
  const float side = ui.px(kPreviewSide), height = side + ImGui::GetFrameHeightWithSpacing();
  if (source_) {
    ImGui::BeginDisabled(weaving_);
    drawPreview(ui, woven, side);
    ImGui::SameLine(0, ui.px(16));
    ImGui::BeginChild("picture.fields", ImVec2(0, height));
    drawFields(ui);
    ImGui::EndChild();
    ImGui::EndDisabled();
    ui.probe.fact("picture.colours", std::to_string(preview_.palette.size()));
  } else {
    ImGui::BeginChild("picture.reading", ImVec2(0, height));
    hint(ui, fmt::format(words::picture::isBeingRead, name_));
    ImGui::EndChild();
  }
  ui.probe.fact("picture.state", !source_ ? "reading" : weaving_ ? "weaving" : "ready");
  const float width = ui.px(120);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ui.px(24));
  const bool cancelled = button(ui, "picture.close", words::common::cancel, width) || modalCancelled(ui);
  ImGui::SameLine();
  const bool canWeave = source_ && !weaving_;
  const bool weaves =
      mainButton(ui, "picture.weave", weaving_ ? words::picture::weaving : words::picture::weave, width, canWeave) ||
      (canWeave && modalConfirmed(ui));
  if (cancelled || std::exchange(closing_, false)) closeModal(open_);
  endModal();
  if (!weaves) return std::nullopt;
  weaving_ = true;
  return order();
}

}  // namespace loomlight
