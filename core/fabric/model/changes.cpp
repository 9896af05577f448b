#include "core/fabric/model/changes.h"

#include <algorithm>

#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

template <class Object>
Stages between(const Object& a, const Object& b);

/// The stages of a field whose values differ.
template <class Value>
Stages stagesOf(const FieldInfo& info, const Value&, const Value&) {
  return info.stages;
}

/// Dyes have fields of their own: what one is called colours nothing.
Stages stagesOf(const FieldInfo& info, const Absorption& a, const Absorption& b) {
  if (a.primaries != b.primaries || a.bands != b.bands || a.dyes.size() != b.dyes.size()) return info.stages;
  Stages stages;
  for (size_t i = 0; i < a.dyes.size(); ++i) stages |= between(a.dyes[i], b.dyes[i]);
  return stages;
}

/// The stages of all fields in which two objects differ.
template <class Object>
Stages between(const Object& a, const Object& b) {
  Stages stages;
  forEachField<Object>([&](const auto& field) {
    if (!(a.*field.member == b.*field.member)) stages |= stagesOf(field.info, a.*field.member, b.*field.member);
  });
  return stages;
}

/// The yarn with one and the same value wherever it has no use for any.
Yarn inUse(Yarn yarn) {
  const Yarn none;
  yarn.blendShare = yarn.blendFibre ? std::optional(yarn.blendShare.value_or(0.5)) : std::nullopt;
  if (yarn.fibresPerPly) yarn.count_tex = none.count_tex;
  if (yarn.plies == 1) yarn.yarnTwist_per_m = 0;
  if (yarn.cords == 1) yarn.cableTwist_per_m = 0;
  if (yarn.plyTwist_per_m == 0) yarn.plyTwistDirection = none.plyTwistDirection;
  if (yarn.yarnTwist_per_m == 0) yarn.yarnTwistDirection = none.yarnTwistDirection;
  if (yarn.cableTwist_per_m == 0) yarn.cableTwistDirection = none.cableTwistDirection;
  if (yarn.hairiness_per_mm == 0) yarn.hairLength_mm = none.hairLength_mm;
  if (isMonofilament(yarn)) yarn.evennessCv_percent = yarn.slubs_per_m = 0;
  if (yarn.slubs_per_m == 0) {
    yarn.slubLength_mm = none.slubLength_mm;
    yarn.slubRatio = none.slubRatio;
  }
  return yarn;
}

/// Notes which yarns take whose places: [a][b] where threads of yarn a become of yarn b. Two periodic words that agree
/// on a length of both periods together agree everywhere (Fine and Wilf 1965).
void pair(const std::vector<int>& before, const std::vector<int>& after, std::vector<std::vector<bool>>& pairs) {
  for (size_t i = 0; i < before.size() + after.size(); ++i)
    pairs[before[i % before.size()]][after[i % after.size()]] = true;
}

void compareThreads(const Fabric& before, const Fabric& after, Changes& changes) {
  std::vector<std::vector<bool>> pairs(before.yarns.size(), std::vector<bool>(after.yarns.size()));
  pair(before.warpSequence, after.warpSequence, pairs);
  pair(before.weftSequence, after.weftSequence, pairs);
  for (int a = 0; a < static_cast<int>(before.yarns.size()); ++a)
    for (int b = 0; b < static_cast<int>(after.yarns.size()); ++b) {
      if (!pairs[a][b]) continue;
      if (a != b) changes.stages |= Stage::thread;
      if (sameShape(before, a, after, b)) continue;
      changes.stages |= Stage::shape;
      if (a == b) {
        changes.yarns.push_back(b);
      } else {
        changes.crossings = true;  // a thread has taken another yarn's place
      }
    }
}

/// What yarns and fibres are, one by one. How they lie is compareThreads()' to say: of those in use alone.
void compareMaterials(const Fabric& before, const Fabric& after, Changes& changes) {
  Stages stages;
  if (before.yarns.size() != after.yarns.size() || before.fibres.size() != after.fibres.size()) stages = Stage::optics;
  for (size_t i = 0; i < std::min(before.yarns.size(), after.yarns.size()); ++i)
    stages |= between(inUse(before.yarns[i]), inUse(after.yarns[i]));
  for (size_t i = 0; i < after.fibres.size(); ++i) {
    const Stages own = i < before.fibres.size() ? between(before.fibres[i], after.fibres[i]) : Stage::optics;
    if (own.any(Stage::optics) || before.mercerised != after.mercerised) changes.fibres.push_back(static_cast<int>(i));
    stages |= own;
  }
  changes.stages |= stages - Stage::shape;
}

}  // namespace

bool sameShape(const Fabric& before, int a, const Fabric& after, int b) {
  const auto unnumbered = [](Yarn yarn) {
    yarn.fibre = 0;
    yarn.blendFibre.reset();
    return inUse(yarn);
  };
  const Yarn &x = before.yarns[a], &y = after.yarns[b];
  return !(between(unnumbered(x), unnumbered(y)) | between(meanFibre(x, before.fibres), meanFibre(y, after.fibres)))
              .any(Stage::shape);
}

Changes changes(const Fabric& before, const Fabric& after) {
  Changes changes;
  changes.stages = between(before.camera, after.camera);
  // The eye carries the headlight; no other lamp moves with it.
  if (after.light.kind != LightKind::headlight) changes.stages -= Stage::light;
  changes.stages |= between(before, after) | between(before.drape, after.drape) | between(before.light, after.light) |
                    between(before.render, after.render) | between(before.mill, after.mill);
  compareMaterials(before, after, changes);
  compareThreads(before, after, changes);
  if (displacements(before.warpSpacing) != displacements(after.warpSpacing) ||
      displacements(before.weftSpacing) != displacements(after.weftSpacing))
    changes.stages |= kSpacingRange.stages;
  if (!(before.weave == after.weave)) {
    changes.stages |= Stage::shape;
    changes.crossings = true;
  }
  return changes;
}

}  // namespace loomlight
