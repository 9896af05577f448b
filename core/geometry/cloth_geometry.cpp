#include "core/geometry/cloth_geometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/base/hash.h"
#include "core/fabric/model/yarn_count.h"
#include "core/geometry/yarn_model.h"

namespace loomlight {
namespace {

int wrap(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// In order.
std::vector<int> divisorsOf(int n) {
  std::vector<int> divisors;
  for (int d = 1; d * d <= n; ++d) {
    if (n % d != 0) continue;
    divisors.push_back(d);
    if (d * d < n) divisors.push_back(n / d);
  }
  std::sort(divisors.begin(), divisors.end());
  return divisors;
}

/// Smallest p that divides n with same(i, i + p) for all i.
template <class Same>
int smallestPeriod(int n, Same&& same) {
  for (const int p : divisorsOf(n)) {
    int i = 0;
    while (i + p < n && same(i, i + p)) ++i;
    if (i + p >= n) return p;
  }
  return n;
}

int periodOf(const std::vector<int>& classes) {
  return smallestPeriod(static_cast<int>(classes.size()), [&](int a, int b) { return classes[a] == classes[b]; });
}

bool sameRow(std::span<const uint8_t> a, std::span<const uint8_t> b) {
  return a.data() == b.data() || std::equal(a.begin(), a.end(), b.begin());
}

/// Smallest p that divides the ends, with which every pick repeats.
int smallestPeriodOfEnds(const Weave& weave) {
  // The periods of a pick that divide n are the multiples of its smallest, so each pick goes on from the one before.
  const std::vector<int> divisors = divisorsOf(weave.ends());
  auto period = divisors.begin();
  for (int pick = 0; pick < weave.picks() && *period < weave.ends(); ++pick) {
    const auto row = weave.row(pick);
    const int step = *period;
    while (*period % step != 0 || !sameRow(row.subspan(static_cast<size_t>(*period)), row.first(row.size() - *period)))
      ++period;
  }
  return *period;
}

int leastCommonMultiple(int a, int b) {
  const int64_t multiple = std::lcm(static_cast<int64_t>(a), static_cast<int64_t>(b));
  return static_cast<int>(std::min<int64_t>(multiple, std::numeric_limits<int>::max()));
}

// What one node of a path comes from: distance to the end of the float in 2 bits, the side in 1, the class crossed in
// the 6 that 64 yarns need. A cell's shape code has its own class above those of its three nodes.
using ShapeCode = ClothGeometry::ShapeCode;
constexpr int kFloatBits = 3, kOverBit = 4, kNodeBits = kFloatBits + 6;
static_assert(kMaxFloatDistance < kOverBit);

// The sides at the crossings within a float's reach of the three nodes of a cell, one bit each, tell how the yarn
// floats at each node: a table, because there is one look-up for every crossing of a jacquard.
constexpr int kReach = ClothGeometry::kCrossingReach, kSidesSeen = 2 * kReach + 1;

constexpr std::array<uint32_t, 1 << kSidesSeen> makeFloatCodes() {
  std::array<uint32_t, 1 << kSidesSeen> codes{};
  for (unsigned sides = 0; sides < codes.size(); ++sides) {
    const auto over = [sides](int i) { return (sides >> i & 1u) != 0; };
    for (int node = 0; node < 3; ++node) {
      const int i = kReach - 1 + node;
      int distance = 0;
      while (distance < kMaxFloatDistance && over(i - distance - 1) == over(i) && over(i + distance + 1) == over(i))
        ++distance;
      codes[sides] = codes[sides] << kNodeBits | static_cast<uint32_t>((over(i) ? kOverBit : 0) | distance);
    }
  }
  return codes;
}
constexpr auto kFloatCodes = makeFloatCodes();

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

ClothGeometry::ClothGeometry(const Fabric& fabric, int ends, int picks, const ClothGeometry* previous, bool sketched,
                             const Task& task)
    : weave_(fabric.weave),
      ends_(ends),
      picks_(picks),
      warpPitch_mm_(fabric.warpPitch_mm()),
      weftPitch_mm_(fabric.weftPitch_mm()) {
  assert(ends >= 1 && picks >= 1);
  resolveYarns(fabric, previous, sketched, task);
  findRepeat();
  findThickness();
}

void ClothGeometry::resolveYarns(const Fabric& fabric, const ClothGeometry* previous, bool sketched, const Task& task) {
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
    of.classes.resize(static_cast<size_t>(periodOf(of.classes)));  // colours alone repeat more slowly
    of.yarns.resize(classCount_);
    const double pitch = system == System::warp ? weftPitch_mm_ : warpPitch_mm_;
    const double crossPitch = system == System::warp ? warpPitch_mm_ : weftPitch_mm_;
    for (const Yarn* yarn : yarnOf) {
      YarnGeometry& outline = outlines[static_cast<size_t>(system)].emplace_back(
          outlineYarn(*yarn, meanFibre(*yarn, fabric.fibres), pitch, crossPitch));
      outline.seed = mixBits(static_cast<uint64_t>(system));
    }
  }
  for (const YarnGeometry& warp : outlines[0])
    for (const YarnGeometry& weft : outlines[1]) crossings_.push_back(cross(warp, weft));

  for (const System system : {System::warp, System::weft}) {
    SystemGeometry& mine = systems_[static_cast<size_t>(system)];
    const std::vector<int>& others = systems_[1 - static_cast<size_t>(system)].classes;
    for (const int own : mine.classes) {
      if (mine.yarns[own]) continue;
      YarnGeometry outline = outlines[static_cast<size_t>(system)][own];
      double interlaced = 0;
      for (const int other : others) {
        const PathNode over = node(system, own, other, true, 0), under = node(system, own, other, false, 0);
        interlaced += Transition(over, under, outline.pitch_mm).length_mm() / static_cast<double>(others.size());
      }
      const Yarn& yarn = *yarnOf[own];
      resolveTwist(outline, yarn, 0.5 * (outline.pitch_mm + interlaced));
      YarnSource source = sourceOf(outline, yarn, meanFibre(yarn, fabric.fibres));
      if (previous)
        for (const auto& model : previous->of(system).yarns)
          if (model && model->source == source) mine.yarns[own] = model;
      if (mine.yarns[own]) continue;
      source.sketched = (sketched || task.stopped()) && isWorthSketching(source);
      mine.yarns[own] = makeYarnModel(source, task);
    }
  }
}

bool ClothGeometry::isSketched() const {
  for (const SystemGeometry& system : systems_)
    for (const auto& yarn : system.yarns)
      if (yarn && yarn->source.sketched) return true;
  return false;
}

void ClothGeometry::findRepeat() {
  const int weavePicks =
      smallestPeriod(weave_.picks(), [&](int a, int b) { return sameRow(weave_.row(a), weave_.row(b)); });
  const int weaveEnds = smallestPeriodOfEnds(weave_);
  repeatEnds_ = leastCommonMultiple(weaveEnds, static_cast<int>(of(System::warp).classes.size()));
  repeatPicks_ = leastCommonMultiple(weavePicks, static_cast<int>(of(System::weft).classes.size()));
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

double ClothGeometry::minFibreRadius_mm() const {
  double least = std::numeric_limits<double>::max();
  for (const SystemGeometry& system : systems_)
    for (const int own : system.classes) least = std::min(least, system.yarns[own]->geometry.fibreRadius_mm);
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

int ClothGeometry::geometryClass(System system, int index) const {
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

/// warpOver(i): of the crossing at i along the yarn, 0 <= i < as many as the weave has.
template <class WarpOver>
void ClothGeometry::shapeCodesOf(System system, int across, int along, const WarpOver& warpOver,
                                 std::span<ShapeCode> codes) const {
  const bool warp = system == System::warp;
  const int alongCount = warp ? weave_.picks() : weave_.ends();
  const std::vector<int>& others = of(warp ? System::weft : System::warp).classes;
  const ShapeCode own = static_cast<ShapeCode>(geometryClass(system, across)) << (3 * kNodeBits);

  // Both slide along the yarn: the sides of the crossings in reach, and the classes of the three yarns that are
  // crossed.
  int ahead = wrap(along - kReach, alongCount);
  unsigned sides = 0;
  const auto see = [&] {
    const bool over = warpOver(ahead) == warp;
    sides = sides >> 1 | static_cast<unsigned>(over) << (kSidesSeen - 1);
    if (++ahead == alongCount) ahead = 0;
  };
  for (int i = 0; i < kSidesSeen - 1; ++i) see();
  auto other = static_cast<size_t>(wrap(along - 1, static_cast<int>(others.size())));
  ShapeCode crossed = 0;
  const auto cross = [&] {
    crossed = (crossed << kNodeBits | static_cast<ShapeCode>(others[other]) << kFloatBits) &
              ((ShapeCode{1} << (3 * kNodeBits)) - 1);
    if (++other == others.size()) other = 0;
  };
  cross();
  cross();
  for (ShapeCode& code : codes) {
    see();
    cross();
    code = own | crossed | kFloatCodes[sides];
  }
}

void ClothGeometry::shapeCodes(System system, int across, int along, std::span<const uint8_t> crossings,
                               std::span<ShapeCode> codes) const {
  const uint8_t* const sides = crossings.data();
  shapeCodesOf(system, across, along, [sides](int i) { return sides[i] != 0; }, codes);
}

void ClothGeometry::shapeCodes(System system, int across, int along, std::span<ShapeCode> codes) const {
  if (system == System::weft) {
    shapeCodes(system, across, along, weave_.row(wrap(across, weave_.picks())), codes);
  } else {
    const int end = wrap(across, weave_.ends());
    shapeCodesOf(system, across, along, [this, end](int pick) { return weave_.at(pick, end); }, codes);
  }
}

CellKey ClothGeometry::shapeKey(System system, ShapeCode code) const {
  const int own = static_cast<int>(code >> (3 * kNodeBits));
  const auto nodeAt = [&](int place) {
    const int bits = static_cast<int>(code >> (place * kNodeBits)) & ((1 << kNodeBits) - 1);
    return node(system, own, bits >> kFloatBits, (bits & kOverBit) != 0, bits & (kOverBit - 1));
  };
  return {system, own, 0, nodeAt(2), nodeAt(1), nodeAt(0)};
}

CellKey ClothGeometry::key(System system, int pick, int end) const {
  ShapeCode code;
  shapeCodes(system, system == System::warp ? end : pick, system == System::warp ? pick : end, {&code, 1});
  CellKey key = shapeKey(system, code);
  key.phase = phase(system, pick, end);
  return key;
}

int ClothGeometry::phase(System system, int pick, int end) const {
  const int along = system == System::warp ? pick : end, across = system == System::warp ? end : pick;
  const YarnGeometry& g = yarn(system, geometryClass(system, across));
  const int start = static_cast<int>(mixBits(g.seed ^ static_cast<uint32_t>(across)) % static_cast<uint64_t>(g.period));
  return (wrap(along, g.period) + start) % g.period;
}

bool ClothGeometry::differsInWeaveOnly(const ClothGeometry& other) const {
  const auto sameModel = [](const std::shared_ptr<const YarnModel>& a, const std::shared_ptr<const YarnModel>& b) {
    return a == b || (a && b && a->geometry == b->geometry);
  };
  const auto sameSystem = [&](const SystemGeometry& a, const SystemGeometry& b) {
    return a.classes == b.classes &&
           std::equal(a.yarns.begin(), a.yarns.end(), b.yarns.begin(), b.yarns.end(), sameModel);
  };
  return sameSystem(systems_[0], other.systems_[0]) && sameSystem(systems_[1], other.systems_[1]) &&
         ends_ == other.ends_ && picks_ == other.picks_ && warpPitch_mm_ == other.warpPitch_mm_ &&
         weftPitch_mm_ == other.weftPitch_mm_ && sameNodes(other);
}

std::optional<ClothGeometry::ClassNames> ClothGeometry::namesOfClasses(const ClothGeometry& other) const {
  ClassNames names;
  std::array<std::vector<int>, 2> here, there;  // the classes in use, pair by pair
  for (size_t system = 0; system < 2; ++system) {
    const std::vector<int>&mine = systems_[system].classes, &others = other.systems_[system].classes;
    if (mine.size() != others.size()) return std::nullopt;
    names[system].assign(static_cast<size_t>(other.classCount_), -1);
    std::vector<int> back(static_cast<size_t>(classCount_), -1);
    for (size_t i = 0; i < mine.size(); ++i) {
      int &name = names[system][others[i]], &former = back[mine[i]];
      if (name < 0 && former < 0) {
        here[system].push_back(name = mine[i]);
        there[system].push_back(former = others[i]);
      }
      if (name != mine[i] || former != others[i]) return std::nullopt;
    }
  }
  for (const System system : {System::warp, System::weft}) {
    const auto own = static_cast<size_t>(system), crossed = 1 - own;
    for (size_t i = 0; i < here[own].size(); ++i)
      if (nodeGroups(system, here[own][i], here[crossed]) != other.nodeGroups(system, there[own][i], there[crossed]))
        return std::nullopt;
  }
  return names;
}

ClothGeometry::ShapeCode ClothGeometry::renamed(System system, ShapeCode code, const ClassNames& names) {
  const auto own = static_cast<size_t>(system), crossed = 1 - own;
  const auto name = [](const std::vector<int>& of, ShapeCode number) {
    return static_cast<ShapeCode>(of[static_cast<size_t>(number)]);
  };
  ShapeCode result = name(names[own], code >> (3 * kNodeBits)) << (3 * kNodeBits);
  for (int place = 0; place < 3; ++place) {
    const ShapeCode node = code >> (place * kNodeBits) & ((1 << kNodeBits) - 1);
    const ShapeCode floating = node & ((1 << kFloatBits) - 1);
    result |= (name(names[crossed], node >> kFloatBits) << kFloatBits | floating) << (place * kNodeBits);
  }
  return result;
}

/// Of all nodes that a yarn's path may have, crossing these classes on either side: the number of the first equal one.
std::vector<int> ClothGeometry::nodeGroups(System system, int own, const std::vector<int>& crossed) const {
  std::map<std::array<float, 3>, int> first;
  std::vector<int> groups;
  for (const int other : crossed)
    for (const bool over : {true, false})
      for (int distance = 0; distance <= kMaxFloatDistance; ++distance) {
        const PathNode n = node(system, own, other, over, distance);
        const auto number = static_cast<int>(groups.size());
        groups.push_back(first.try_emplace({n.height_mm, n.radius_mm, n.flat_mm}, number).first->second);
      }
  return groups;
}

/// Whether all paths have the same nodes: crossings differ by more digits than nodes keep. The yarns must be the same.
bool ClothGeometry::sameNodes(const ClothGeometry& other) const {
  if (crossings_ == other.crossings_) return true;
  for (const System system : {System::warp, System::weft}) {
    const auto& crossedYarns = of(system == System::warp ? System::weft : System::warp).yarns;
    for (int own = 0; own < classCount_; ++own)
      for (int crossed = 0; crossed < classCount_; ++crossed) {
        if (!of(system).yarns[own] || !crossedYarns[crossed]) continue;
        for (int distance = 0; distance <= kMaxFloatDistance; ++distance)
          if (!(node(system, own, crossed, true, distance) == other.node(system, own, crossed, true, distance)))
            return false;
      }
  }
  return true;
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
