#include "core/geometry/cloth_geometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/hash.h"
#include "core/geometry/yarn_model.h"

namespace loomlight {
namespace {

int wrap(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// Smallest p that divides n with same(i, i + p) for all i.
template <class Same>
int smallestPeriod(int n, Same&& same) {
  for (int p = 1; p < n; ++p) {
    if (n % p != 0) continue;
    int i = 0;
    while (i + p < n && same(i, i + p)) ++i;
    if (i + p >= n) return p;
  }
  return n;
}

int leastCommonMultiple(int a, int b) {
  const int64_t multiple = std::lcm(static_cast<int64_t>(a), static_cast<int64_t>(b));
  return static_cast<int>(std::min<int64_t>(multiple, std::numeric_limits<int>::max()));
}

}  // namespace

uint64_t hash(const CellKey& key) {
  uint64_t h = hashCombine(0, static_cast<int>(key.system));
  h = hashCombine(h, key.yarn);
  h = hashCombine(h, key.phase);
  for (const PathNode* node : {&key.previous, &key.here, &key.next}) {
    h = hashCombine(h, node->height_mm);
    h = hashCombine(h, node->radius_mm);
    h = hashCombine(h, node->flat_mm);
  }
  return h;
}

ClothGeometry::ClothGeometry(const Fabric& fabric, int ends, int picks)
    : weave_(fabric.weave),
      ends_(ends),
      picks_(picks),
      warpPitch_mm_(fabric.warpPitch_mm()),
      weftPitch_mm_(fabric.weftPitch_mm()) {
  assert(ends >= 1 && picks >= 1);
  resolveYarns(fabric);
  findRepeat();
  findThickness();
}

void ClothGeometry::resolveYarns(const Fabric& fabric) {
  const std::vector<int> classOf = geometryClasses(fabric);
  classCount_ = *std::max_element(classOf.begin(), classOf.end()) + 1;
  std::vector<const Yarn*> yarnOf(classCount_);
  for (size_t i = classOf.size(); i-- > 0;) yarnOf[classOf[i]] = &fabric.yarns[i];

  // Outlines first: a yarn's path depends on the outlines of those it crosses.
  std::array<std::vector<YarnGeometry>, 2> outlines;
  for (const System system : {System::warp, System::weft}) {
    SystemGeometry& of = systems_[static_cast<size_t>(system)];
    of.sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
    for (const int index : of.sequence) of.classes.push_back(classOf[index]);
    of.yarns.resize(classCount_);
    const double pitch = system == System::warp ? weftPitch_mm_ : warpPitch_mm_;
    const double crossPitch = system == System::warp ? warpPitch_mm_ : weftPitch_mm_;
    for (const Yarn* yarn : yarnOf) {
      YarnGeometry& outline = outlines[static_cast<size_t>(system)].emplace_back(
          outlineYarn(*yarn, fabric.fibres[yarn->fibre], pitch, crossPitch));
      outline.seed = mixBits(static_cast<uint64_t>(system));
    }
  }
  for (const YarnGeometry& warp : outlines[0])
    for (const YarnGeometry& weft : outlines[1]) crossings_.push_back(cross(warp, weft));

  for (const System system : {System::warp, System::weft}) {
    SystemGeometry& of = systems_[static_cast<size_t>(system)];
    const std::vector<int>& others = systems_[1 - static_cast<size_t>(system)].classes;
    for (const int own : of.classes) {
      if (of.yarns[own]) continue;
      YarnGeometry outline = outlines[static_cast<size_t>(system)][own];
      double interlaced = 0;
      for (const int other : others) {
        const PathNode over = node(system, own, other, true, 0), under = node(system, own, other, false, 0);
        interlaced += Transition(over, under, outline.pitch_mm).length_mm() / static_cast<double>(others.size());
      }
      const Yarn& yarn = *yarnOf[own];
      resolveTwist(outline, yarn, 0.5 * (outline.pitch_mm + interlaced));
      of.yarns[own] = makeYarnModel(outline, yarn, fabric.fibres[yarn.fibre]);
    }
  }
}

void ClothGeometry::findRepeat() {
  const auto periodOf = [](const std::vector<int>& classes) {
    return smallestPeriod(static_cast<int>(classes.size()), [&](int a, int b) { return classes[a] == classes[b]; });
  };
  const int weavePicks = smallestPeriod(weave_.picks(), [&](int a, int b) {
    const auto first = weave_.row(a), second = weave_.row(b);
    return std::equal(first.begin(), first.end(), second.begin());
  });
  const int weaveEnds = smallestPeriod(weave_.ends(), [&](int a, int b) {
    for (int pick = 0; pick < weavePicks; ++pick)
      if (weave_.at(pick, a) != weave_.at(pick, b)) return false;
    return true;
  });
  repeatEnds_ = leastCommonMultiple(weaveEnds, periodOf(of(System::warp).classes));
  repeatPicks_ = leastCommonMultiple(weavePicks, periodOf(of(System::weft).classes));
}

void ClothGeometry::findThickness() {
  for (const System system : {System::warp, System::weft}) {
    const System otherSystem = system == System::warp ? System::weft : System::warp;
    for (int own = 0; own < classCount_; ++own)
      for (int other = 0; other < classCount_; ++other) {
        if (!of(system).yarns[own] || !of(otherSystem).yarns[other]) continue;
        const double crown = node(system, own, other, true, kMaxFloatDistance).height_mm;
        halfThickness_mm_ = std::max(halfThickness_mm_, crown + of(system).yarns[own]->reachUp_mm());
      }
  }
}

double ClothGeometry::minYarnDiameter_mm() const {
  double least = std::numeric_limits<double>::max();
  for (const SystemGeometry& system : systems_)
    for (const int own : system.classes) least = std::min(least, system.yarns[own]->geometry.diameter_mm());
  return least;
}

const YarnGeometry& ClothGeometry::yarn(System system, int geometryClass) const {
  assert(of(system).yarns[geometryClass]);
  return of(system).yarns[geometryClass]->geometry;
}

int ClothGeometry::yarnIndex(System system, int index) const {
  const std::vector<int>& sequence = of(system).sequence;
  return sequence[wrap(index, static_cast<int>(sequence.size()))];
}

int ClothGeometry::classAt(System system, int index) const {
  const std::vector<int>& classes = of(system).classes;
  return classes[wrap(index, static_cast<int>(classes.size()))];
}

PathNode ClothGeometry::node(System system, int own, int other, bool over, int floatDistance) const {
  const bool warp = system == System::warp;
  const Crossing& c = crossings_[static_cast<size_t>(warp ? own : other) * classCount_ + (warp ? other : own)];
  const double rise = floatDistance > 0 ? floatRise_mm(yarn(system, own), floatDistance) : 0.0;
  const double height = (warp ? c.warpHeight_mm : c.weftHeight_mm) + rise;
  return {static_cast<float>(over ? height : -height), static_cast<float>(warp ? c.warpRadius_mm : c.weftRadius_mm),
          static_cast<float>(warp ? c.warpFlat_mm : c.weftFlat_mm)};
}

CellKey ClothGeometry::shapeKey(System system, int pick, int end) const {
  const bool warp = system == System::warp;
  const int along = warp ? pick : end, across = warp ? end : pick;
  const int alongCount = warp ? weave_.picks() : weave_.ends();
  const int acrossIndex = wrap(across, warp ? weave_.ends() : weave_.picks());

  // Which side the yarn is on at the crossings within a float's reach of the three nodes.
  constexpr int kReach = kMaxFloatDistance + 2;
  std::array<bool, 2 * kReach + 1> over;
  int i = wrap(along - kReach, alongCount);
  for (bool& up : over) {
    up = warp ? weave_.at(i, acrossIndex) : !weave_.at(acrossIndex, i);
    if (++i == alongCount) i = 0;
  }
  const int own = classAt(system, across);
  const System otherSystem = warp ? System::weft : System::warp;
  const auto nodeAt = [&](int offset) {
    const int centre = kReach + offset;
    int distance = 0;
    while (distance < kMaxFloatDistance && over[centre - distance - 1] == over[centre] &&
           over[centre + distance + 1] == over[centre])
      ++distance;
    return node(system, own, classAt(otherSystem, along + offset), over[centre], distance);
  };
  return {system, own, 0, nodeAt(-1), nodeAt(0), nodeAt(1)};
}

CellKey ClothGeometry::key(System system, int pick, int end) const {
  CellKey key = shapeKey(system, pick, end);
  key.phase = phase(system, pick, end);
  return key;
}

int ClothGeometry::phase(System system, int pick, int end) const {
  const int along = system == System::warp ? pick : end, across = system == System::warp ? end : pick;
  const YarnGeometry& g = yarn(system, classAt(system, across));
  const int start = static_cast<int>(mixBits(g.seed ^ static_cast<uint32_t>(across)) % static_cast<uint64_t>(g.period));
  return (wrap(along, g.period) + start) % g.period;
}

CellStrands ClothGeometry::strands(const CellKey& key) const {
  const YarnModel& model = *of(key.system).yarns[key.yarn];
  const YarnGeometry& g = model.geometry;
  CellStrands cell = layStrands(model, key.previous, key.here, key.next, key.phase, g.pitch_mm);
  const double straight = model.straightLength_mm[key.phase] * axisLength_mm(key) / g.cellLength_mm;
  cell.fibreRadius_mm = static_cast<float>(g.fibreRadius_mm * std::sqrt(straight / cell.length_mm()));
  return cell;
}

double ClothGeometry::axisLength_mm(const CellKey& key) const {
  const double pitch = yarn(key.system, key.yarn).pitch_mm;
  const Transition before(key.previous, key.here, pitch), after(key.here, key.next, pitch);
  return before.length_mm() - before.lengthTo(0.5 * pitch) + after.lengthTo(0.5 * pitch);
}

}  // namespace loomlight
