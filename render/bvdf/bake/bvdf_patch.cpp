#include "render/bvdf/bake/bvdf_patch.h"

#include <algorithm>
#include <cmath>

#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/yarn_edit.h"

// How it works. What local visibility depends on is copied from the fabric by the stages of its fields: the corner of a
// large weave, yarns of one shape as one yarn, a mean fibre, white light. The patch of it is some whole repeats wide,
// and is cut down until its fibres are few enough to be traced one by one.

namespace loomlight {
namespace {

constexpr Stages kSeen = Stage::shape | Stage::grid;  // of a fabric, in a table

constexpr int kCrossings = 12;     // a side, at least: some of every phase of the twist
constexpr int kMaxCrossings = 48;  // a side; a larger repeat is cut off
constexpr int kMinCrossings = 3;   // one that has neighbours all around it
constexpr int kMaxWeave = 256;     // a side; of larger ones the corner is the weave
constexpr double kMaxSegments = 6e5;
constexpr double kMaxBytes = 2.0 * (1 << 30);

/// Whole repeats, at least kCrossings, at most kMaxCrossings.
int sideOf(int repeat) {
  const int repeats = (kCrossings + repeat - 1) / repeat;
  return std::clamp(repeats * repeat, kMinCrossings, kMaxCrossings);
}

double segmentsPerCrossing(const Fabric& fabric) {
  const ClothGeometry few(fabric, kMinCrossings, kMinCrossings);
  const int ends = std::min(few.repeatEnds(), kMinCrossings), picks = std::min(few.repeatPicks(), kMinCrossings);
  return few.measure().segmentsPerRepeat / (ends * picks);
}

/// Keeps the work on a large figure, and the text of the recipe, in proportion to the patch.
Weave cornerOf(const Weave& weave) {
  if (weave.ends() <= kMaxWeave && weave.picks() <= kMaxWeave) return weave;
  std::vector<Weave::Row> rows;
  for (int pick = 0; pick < std::min(weave.picks(), kMaxWeave); ++pick) {
    const auto row = weave.row(pick);
    rows.emplace_back(row.begin(), row.begin() + std::min(weave.ends(), kMaxWeave));
  }
  return Weave(rows);
}

/// Yarns of one geometry class are one yarn.
void mergeYarns(const Fabric& fabric, Fabric& merged) {
  const std::vector<int> classes = geometryClasses(fabric);
  merged.yarns.clear();
  merged.fibres.clear();
  for (size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] < static_cast<int>(merged.yarns.size())) continue;
    Yarn yarn = onlyOf(kSeen, fabric.yarns[i]);
    yarn.name.clear();
    yarn.fibre = classes[i];
    yarn.blendFibre.reset();
    merged.yarns.push_back(yarn);
    merged.fibres.push_back(onlyOf(kSeen, meanFibre(fabric.yarns[i], fabric.fibres)));
    merged.fibres.back().name.clear();
  }
  for (int& yarn : merged.warpSequence) yarn = classes[yarn];
  for (int& yarn : merged.weftSequence) yarn = classes[yarn];
}

}  // namespace

Fabric BvdfPatch::reduced(const Fabric& fabric) {
  Fabric patch = onlyOf(kSeen, fabric);
  patch.name.clear();
  patch.weave = cornerOf(fabric.weave);
  patch.warpSequence = fabric.warpSequence;
  patch.weftSequence = fabric.weftSequence;
  patch.warpSpacing = fabric.warpSpacing;
  patch.weftSpacing = fabric.weftSpacing;
  mergeYarns(fabric, patch);
  patch = evenlySpun(std::move(patch));  // a few crossings are no average of thick, thin and displaced places
  patch.light.kind = LightKind::dome;
  patch.render = onlyOf(kSeen, fabric.render);

  const ClothGeometry geometry = ClothGeometry::outline(patch);
  int ends = sideOf(geometry.repeatEnds()), picks = sideOf(geometry.repeatPicks());
  const double each = segmentsPerCrossing(patch);
  while (each * ends * picks > kMaxSegments && std::max(ends, picks) > kMinCrossings) {
    int& longer = ends > picks ? ends : picks;
    longer = std::max(kMinCrossings, longer - 1 - longer / 8);
  }
  patch.drape.width_mm = ends * patch.warpPitch_mm();
  patch.drape.height_mm = picks * patch.weftPitch_mm();
  return patch;
}

std::unique_ptr<const BvdfPatch> BvdfPatch::build(const Fabric& fabric, const Task& task) {
  std::unique_ptr<BvdfPatch> patch(new BvdfPatch());
  const Task quiet{task.stop, {}, task.threads};
  patch->scene_ = makeScene(std::make_shared<const Fabric>(reduced(fabric)), quiet);
  if (!patch->scene_) return nullptr;
  patch->fibres_ = FibreMedium::build(patch->scene_->cloth, kMaxBytes, quiet);
  if (!patch->fibres_) return nullptr;
  return patch;
}

bool BvdfPatch::isInside(int end, int pick) const {
  const ClothGeometry& geometry = scene_->cloth->volume->geometry();
  return end > 0 && pick > 0 && end + 1 < geometry.ends() && pick + 1 < geometry.picks();
}

}  // namespace loomlight
