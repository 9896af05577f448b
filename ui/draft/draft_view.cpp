#include "ui/draft/draft_view.h"

#include <algorithm>
#include <cmath>

#include "core/base/modulo.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {

const DerivedDraft& ShownDraft::of(const Weave& weave, const LoomLimits& limits, bool liftplan) {
  if (weave_ && *weave_ == weave && limits_ == limits && liftplan_ == liftplan) return derived_;
  weave_ = weave;
  limits_ = limits;
  liftplan_ = liftplan;
  Draft like;
  if (liftplan) like.liftplan.resize(1);
  derived_ = deriveDraft(weave, limits, like);
  return derived_;
}

float DraftFrame::x(double end) const {
  const float along = static_cast<float>(end - origin.x) * cell;
  return fromRight ? box.max.x - along : box.min.x + along;
}

float DraftFrame::y(double pick) const {
  const float along = static_cast<float>(pick - origin.y) * cellHeight();
  return fromTop ? box.min.y + along : box.max.y - along;
}

Box DraftFrame::cells(int pick, int end, int picks, int ends) const {
  const float x0 = std::round(x(end)), x1 = std::round(x(end + ends));
  const float y0 = std::round(y(pick)), y1 = std::round(y(pick + picks));
  return {ImVec2(std::min(x0, x1), std::min(y0, y1)), ImVec2(std::max(x0, x1), std::max(y0, y1))};
}

CrossingIndex DraftFrame::at(ImVec2 p) const {
  const float alongEnds = fromRight ? box.max.x - p.x : p.x - box.min.x;
  const float alongPicks = fromTop ? p.y - box.min.y : box.max.y - p.y;
  return {static_cast<int>(std::floor(alongPicks / cellHeight() + origin.y)),
          static_cast<int>(std::floor(alongEnds / cell + origin.x))};
}

int DraftFrame::firstEnd() const {
  return static_cast<int>(std::floor(origin.x));
}
int DraftFrame::lastEnd() const {
  return static_cast<int>(std::ceil(origin.x + box.width() / cell)) - 1;
}
int DraftFrame::firstPick() const {
  return static_cast<int>(std::floor(origin.y));
}
int DraftFrame::lastPick() const {
  return static_cast<int>(std::ceil(origin.y + box.height() / cellHeight())) - 1;
}

DraftFrame frameOf(const DraftView& view, const DraftPreferences& preferences, const Box& box) {
  return {
      box,      view.cell, view.aspect, view.origin, preferences.startsRight() != view.back, preferences.startsAtTop(),
      view.back};
}

float cellAspect(const Fabric& fabric) {
  const CrossingShape shape = crossingShape(fabric);
  return static_cast<float>(shape.height / shape.width);
}

void fitDraft(DraftView& view, const Weave& weave, ImVec2 size, float scale) {
  // A tiny repeat is shown several times over: what a weave looks like shows only where it repeats.
  constexpr int kFewestCells = 12;
  const float ends = static_cast<float>(std::max(weave.ends(), kFewestCells));
  const float picks = static_cast<float>(std::max(weave.picks(), kFewestCells));
  const float cell = std::min(size.x / ends, size.y / (picks * view.aspect));
  view.cell = cell >= 4 * scale ? std::floor(cell) : std::max(cell, 0.02f);
  view.origin = ImVec2(0, 0);
}

void showFloat(DraftView& view, const FloatRun& run) {
  const bool warp = run.system == System::warp;
  const auto middle = static_cast<float>(run.first) + 0.5f * static_cast<float>(run.cells);
  const auto across = static_cast<float>(run.across) + 0.5f;
  view.origin = ImVec2((warp ? across : middle) - 0.5f * view.seen.x, (warp ? middle : across) - 0.5f * view.seen.y);
}

void zoomDraft(DraftView& view, const DraftFrame& frame, ImVec2 pointer, float clicks) {
  const float smallest = 0.02f, largest = 96.0f;
  const float old = view.cell;
  view.cell = std::clamp(old * std::exp(0.16f * clicks), smallest, largest);
  const float alongEnds = frame.fromRight ? frame.box.max.x - pointer.x : pointer.x - frame.box.min.x;
  const float alongPicks = frame.fromTop ? pointer.y - frame.box.min.y : frame.box.max.y - pointer.y;
  view.origin.x += alongEnds / old - alongEnds / view.cell;
  view.origin.y += (alongPicks / old - alongPicks / view.cell) / view.aspect;
  // Far from the origin a float no longer tells neighbouring cells apart; nobody weaves there.
  constexpr float kFar = 1e5f;
  view.origin.x = std::clamp(view.origin.x, -kFar, kFar);
  view.origin.y = std::clamp(view.origin.y, -kFar, kFar);
}

CellRect selectionBetween(const CrossingIndex& a, const CrossingIndex& b, const Weave& weave) {
  const CrossingIndex corner = inRepeat({std::min(a.pick, b.pick), std::min(a.end, b.end)}, weave);
  return {corner.pick, corner.end, std::min(std::abs(a.pick - b.pick) + 1, weave.picks()),
          std::min(std::abs(a.end - b.end) + 1, weave.ends())};
}

bool isSelected(const CellRect& selection, const CrossingIndex& crossing, const Weave& weave) {
  return wrap(crossing.end - selection.end, weave.ends()) < selection.ends &&
         wrap(crossing.pick - selection.pick, weave.picks()) < selection.picks;
}

const Draft* draftBeside(const Fabric& fabric, const DraftPreferences& preferences, DraftView& view,
                         std::string* remark) {
  if (fabric.draft) return &*fabric.draft;
  if (view.loom == DraftView::Loom::jacquard) return nullptr;
  const DerivedDraft& derived =
      view.shownDraft.of(fabric.weave, preferences.loom, view.loom == DraftView::Loom::liftplan);
  if (remark) *remark = derived.remark;
  return derived.draft ? &*derived.draft : nullptr;
}

}  // namespace loomlight
