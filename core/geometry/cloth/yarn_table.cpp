#include "core/geometry/cloth/yarn_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/base/hash.h"
#include "core/base/modulo.h"
#include "core/base/period.h"
#include "core/fabric/model/yarn_count.h"

// How it works. What a yarn is like depends on its neighbours, so it is resolved in steps. The outline of each class of
// yarns follows from its count and finish; two outlines give a crossing (how high each yarn goes over the other); with
// both it is known how close threads may lie where the sett is not even (threadKinds); the paths over all crossings
// give the length of a yarn in a cell, and with that its twist per cell; and only then are its fibres laid out
// (makeYarnModel), which takes the time. Models of the table before serve again where their source is equal.

namespace loomlight {
namespace {

/// The yarn of this source, where these have it, or one that is it but for its evenness; else null.
std::shared_ptr<const YarnModel> reused(const std::vector<std::shared_ptr<const YarnModel>>& models,
                                        const YarnSource& source) {
  for (const auto& model : models)
    if (model && model->source == source) return model;
  YarnSource other = source;
  for (const auto& model : models) {
    if (!model) continue;
    other.resolved.evenness = model->source.resolved.evenness;
    if (model->source == other) return withEvenness(*model, source.resolved.evenness);
  }
  return nullptr;
}

}  // namespace

YarnTable::YarnTable(const Fabric& fabric, const YarnTable* previous, bool sketched, const Task& task,
                     const Tiling& tiling)
    : crowded_(fabric.crowding > 0),
      warpPitch_mm_(fabric.warpPitch_mm()),
      weftPitch_mm_(fabric.weftPitch_mm()),
      tiling_(tiling) {
  resolve(fabric, previous, sketched, task);
  findThickness();
}

void YarnTable::resolve(const Fabric& fabric, const YarnTable* previous, bool sketched, const Task& task) {
  const std::vector<int> classOf = geometryClasses(fabric);
  classCount_ = *std::max_element(classOf.begin(), classOf.end()) + 1;
  std::vector<const Yarn*> yarnOf(classCount_);
  for (size_t i = classOf.size(); i-- > 0;) yarnOf[classOf[i]] = &fabric.yarns[i];

  // Outlines first: a yarn's path depends on the outlines of those it crosses.
  for (const System system : {System::warp, System::weft}) {
    SystemYarns& of = systems_[static_cast<size_t>(system)];
    of.sequence = fabric.sequence(system);
    of.models.resize(classCount_);
    const double pitch = fabric.pitch_mm(crossSystem(system));
    const double crossPitch = fabric.pitch_mm(system);
    for (const Yarn* yarn : yarnOf) {
      YarnGeometry& outline =
          of.outlines.emplace_back(outlineYarn(withFinish(*yarn, fabric), meanFibre(*yarn, fabric.fibres), pitch,
                                               crossPitch, fabric.press, feltingOf(*yarn, fabric)));
      outline.hairLie = hairLieOf(fabric, system);
      outline.evenness.crowding = crowdingOf(outline.radius_mm, outline.halfWidth_mm(), crossPitch, fabric.crowding);
      // Neighbours move independently of each other, so their distance varies by the root of two more than each does.
      outline.evenness.aside_mm = fabric.settCv_percent / 100 * crossPitch / std::sqrt(2.0);
      outline.seed = mixBits(static_cast<uint64_t>(system));
    }
  }
  for (const YarnGeometry& warp : systems_[0].outlines)
    for (const YarnGeometry& weft : systems_[1].outlines) crossings_.push_back(cross(warp, weft, fabric.crimpBalance));

  std::array<std::vector<int>, 2> classes;  // of threads, by system: colours alone repeat more slowly
  for (size_t system = 0; system < 2; ++system) {
    for (const int index : systems_[system].sequence) classes[system].push_back(classOf[index]);
    classes[system] = shortestRepeat(std::move(classes[system]));
  }
  systems_[0].threads = spaced(System::warp, classes[0], classes[1], fabric.warpSpacing);
  systems_[1].threads = spaced(System::weft, classes[1], classes[0], fabric.weftSpacing);
  for (const System system : {System::warp, System::weft})
    for (YarnGeometry& outline : systems_[static_cast<size_t>(system)].outlines) {
      outline.evenness.displaced_mm = of(system).threads.farthest_mm();
      outline.evenness.crossingsDisplaced_mm = of(crossSystem(system)).threads.farthest_mm();
    }

  for (const System system : {System::warp, System::weft}) {
    SystemYarns& mine = systems_[static_cast<size_t>(system)];
    const std::vector<int>& others = classes[1 - static_cast<size_t>(system)];
    for (const int own : classes[static_cast<size_t>(system)]) {
      if (mine.models[own]) continue;
      YarnGeometry outline = mine.outlines[own];
      double interlaced = 0;
      for (const int other : others) {
        const PathNode over = node(system, own, {other, true, 0}), under = node(system, own, {other, false, 0});
        interlaced += Transition(over, under, outline.pitch_mm).length_mm() / static_cast<double>(others.size());
      }
      const Yarn& yarn = *yarnOf[own];
      resolveTwist(outline, yarn, 0.5 * (outline.pitch_mm + interlaced));
      YarnSource source = sourceOf(outline, yarn, meanFibre(yarn, fabric.fibres));
      if (previous) mine.models[own] = reused(previous->of(system).models, source);
      if (mine.models[own]) continue;
      source.sketched = (sketched || task.stopped()) && isWorthSketching(source);
      mine.models[own] = makeYarnModel(source, task);
    }
  }
}

/// Yarns come no closer than their sections touch, pressed in a little, however far they crowd besides; nor so close
/// that a yarn which goes over one and under the next would be too steep. `crossed`: the classes of the other system.
ThreadKinds YarnTable::spaced(System system, const std::vector<int>& classes, const std::vector<int>& crossed,
                              const std::vector<double>& spacing) const {
  std::vector<double> half_mm(static_cast<size_t>(classCount_)), climb_mm(half_mm);
  const std::set<int> own(classes.begin(), classes.end()), others(crossed.begin(), crossed.end());
  for (const int c : own) {
    const YarnGeometry& outline = of(system).outlines[static_cast<size_t>(c)];
    half_mm[c] = (1 - kPressedIn) * outline.halfWidth_mm() + outline.evenness.crowding.most_mm;
    for (const int other : others)
      forEachState([&](int state, int otherState) {
        const PathNode over = node(crossSystem(system), other, {c, true, state, otherState});
        climb_mm[c] = std::max<double>(climb_mm[c], over.height_mm);
      });
  }
  const double steepest = steepestClimb_mm(1);
  return threadKinds(classes, spacing, system == System::warp ? warpPitch_mm_ : weftPitch_mm_, [&](int a, int b) {
    return std::max(half_mm[a] + half_mm[b], (climb_mm[a] + climb_mm[b]) / steepest);
  });
}

bool YarnTable::isSketched() const {
  for (const SystemYarns& system : systems_)
    for (const auto& yarn : system.models)
      if (yarn && yarn->source.sketched) return true;
  return false;
}

void YarnTable::findThickness() {
  for (const System system : {System::warp, System::weft}) {
    const System otherSystem = crossSystem(system);
    for (int own = 0; own < classCount_; ++own)
      for (int other = 0; other < classCount_; ++other) {
        if (!of(system).models[own] || !of(otherSystem).models[other]) continue;
        forEachState([&](int state, int otherState) {
          const double crown = node(system, own, {other, true, state, otherState}).height_mm;
          halfThickness_mm_ = std::max(halfThickness_mm_, crown + of(system).models[own]->reachUp_mm());
        });
      }
  }
}

double YarnTable::minYarnDiameter_mm() const {
  double least = std::numeric_limits<double>::max();
  for (const SystemYarns& system : systems_)
    for (const auto& yarn : system.models)
      if (yarn) least = std::min(least, 2 * yarn->geometry.reach_mm());
  return least;
}

double YarnTable::minFibreRadius_mm() const {
  double least = std::numeric_limits<double>::max();
  for (const SystemYarns& system : systems_)
    for (const auto& yarn : system.models)
      if (yarn) least = std::min(least, yarn->geometry.fibreRadius_mm);
  return least;
}

const YarnModel& YarnTable::model(System system, int geometryClass) const {
  assert(of(system).models[geometryClass]);
  return *of(system).models[geometryClass];
}

int YarnTable::yarnIndex(System system, int index) const {
  const std::vector<int>& sequence = of(system).sequence;
  return sequence[wrap(index, static_cast<int>(sequence.size()))];
}

PathNode YarnTable::node(System system, int own, const CellShape::Node& at) const {
  const bool warp = system == System::warp;
  const Crossing& c =
      crossings_[static_cast<size_t>(warp ? own : at.crossed) * classCount_ + (warp ? at.crossed : own)];
  const auto state = static_cast<size_t>(at.floatState), otherState = static_cast<size_t>(at.otherState);
  const double height = (warp ? c.warpHeight_mm : c.weftHeight_mm)[state][otherState];
  const YarnGeometry& yarn = of(system).outlines[static_cast<size_t>(own)];
  const SectionOutline& section = yarn.pressed[state];
  // Ends are counted along u of the warp's cells, picks against that of the weft's.
  const float aside = yarn.evenness.crowding.aside_mm(at.floatState, warp ? at.leaning : -at.leaning);
  return {static_cast<float>(at.over ? height : -height), static_cast<float>(section.up),
          static_cast<float>(section.across), aside};
}

YarnCellKey YarnTable::shapeKey(System system, const CellShape& shape) const {
  const ThreadKind& own = of(system).threads.kinds[static_cast<size_t>(shape.own)];
  const auto nodeAt = [&](CellShape::Node at) {
    const ThreadKind& crossed = of(crossSystem(system)).threads.kinds[static_cast<size_t>(at.crossed)];
    at.crossed = crossed.geometryClass;
    PathNode place = node(system, own.geometryClass, at);
    place.aside_mm += system == System::warp ? own.displaced_mm : -own.displaced_mm;
    place.along_mm = crossed.displaced_mm;
    return place;
  };
  return {system, own.geometryClass, 0, 0, nodeAt(shape.previous), nodeAt(shape.here), nodeAt(shape.next)};
}

YarnTable::Place YarnTable::place(System system, int geometryClass, int across, int along) const {
  const YarnModel& yarn = model(system, geometryClass);
  const int period = yarn.geometry.period;
  const int repeat = system == System::warp ? tiling_.ends : tiling_.picks;
  const int thread = repeat > 0 ? wrap(across, repeat) : across;
  const uint64_t bits = mixBits(yarn.geometry.seed ^ static_cast<uint32_t>(thread));
  const int start = static_cast<int>(bits % static_cast<uint64_t>(period)) + wrap(along, period);
  Place place{start % period};
  if (!yarn.spool) return place;
  const int periods = (along - wrap(along, period)) / period + start / period;
  place.stretch = (static_cast<uint32_t>(bits >> 40) + static_cast<uint32_t>(periods)) % Spool::kStretches;
  return place;
}

bool YarnTable::sameShapes(const YarnTable& other) const {
  const auto sameModel = [](const std::shared_ptr<const YarnModel>& a, const std::shared_ptr<const YarnModel>& b) {
    return a == b || (a && b && a->geometry == b->geometry);
  };
  const auto sameSystem = [&](const SystemYarns& a, const SystemYarns& b) {
    return a.threads == b.threads &&
           std::equal(a.models.begin(), a.models.end(), b.models.begin(), b.models.end(), sameModel);
  };
  return sameSystem(systems_[0], other.systems_[0]) && sameSystem(systems_[1], other.systems_[1]) &&
         tiling_ == other.tiling_ && warpPitch_mm_ == other.warpPitch_mm_ && weftPitch_mm_ == other.weftPitch_mm_ &&
         sameNodes(other);
}

std::optional<KindNames> YarnTable::namesOfKinds(const YarnTable& other) const {
  KindNames names;
  std::array<std::vector<int>, 2> here, there;  // the kinds in use, pair by pair
  for (size_t system = 0; system < 2; ++system) {
    const ThreadKinds &mine = systems_[system].threads, &others = other.systems_[system].threads;
    if (mine.sequence.size() != others.sequence.size()) return std::nullopt;
    names[system].assign(others.kinds.size(), -1);
    std::vector<int> back(mine.kinds.size(), -1);
    for (size_t i = 0; i < mine.sequence.size(); ++i) {
      const int kind = mine.sequence[i], before = others.sequence[i];
      int &name = names[system][before], &former = back[kind];
      if (name < 0 && former < 0) {
        here[system].push_back(name = kind);
        there[system].push_back(former = before);
      }
      if (name != kind || former != before) return std::nullopt;
      if (mine.kinds[kind].displaced_mm != others.kinds[before].displaced_mm) return std::nullopt;
    }
    // Threads that are displaced and also lean to others may come to lie as others do.
    if (crowded_ && mine.farthest_mm() > 0) return std::nullopt;
  }
  const auto classes = [](const YarnTable& of, System system, std::vector<int> kinds) {
    for (int& kind : kinds) kind = of.geometryClass(system, kind);
    return kinds;
  };
  for (const System system : {System::warp, System::weft}) {
    const System otherSystem = crossSystem(system);
    const auto own = static_cast<size_t>(system), crossed = 1 - own;
    const std::vector<int> mine = classes(*this, system, here[own]), others = classes(other, system, there[own]);
    const std::vector<int> over = classes(*this, otherSystem, here[crossed]),
                           othersOver = classes(other, otherSystem, there[crossed]);
    for (size_t i = 0; i < mine.size(); ++i)
      if (nodeGroups(system, mine[i], over) != other.nodeGroups(system, others[i], othersOver) ||
          leaningGroups(system, mine[i]) != other.leaningGroups(system, others[i]))
        return std::nullopt;
  }
  return names;
}

/// Of all nodes that a yarn's path may have, crossing these classes on either side: the number of the first equal one.
std::vector<int> YarnTable::nodeGroups(System system, int own, const std::vector<int>& crossed) const {
  std::map<std::array<float, 3>, int> first;
  std::vector<int> groups;
  for (const int other : crossed)
    for (const bool over : {true, false})
      forEachState([&](int state, int otherState) {
        const PathNode n = node(system, own, {other, over, state, otherState});
        const auto number = static_cast<int>(groups.size());
        groups.push_back(first.try_emplace({n.height_mm, n.up, n.across}, number).first->second);
      });
  return groups;
}

/// Of all float states and leanings that a node may have: the number of the first that stands as far aside.
std::vector<int> YarnTable::leaningGroups(System system, int own) const {
  const Crowding& crowding = of(system).outlines[static_cast<size_t>(own)].evenness.crowding;
  std::map<float, int> first;
  std::vector<int> groups;
  for (int state = 0; state < kFloatStates; ++state)
    for (int leaning = -kMostLeaning; leaning <= kMostLeaning; ++leaning)
      groups.push_back(
          first.try_emplace(crowding.aside_mm(state, leaning), static_cast<int>(groups.size())).first->second);
  return groups;
}

/// Whether all paths have the same nodes: crossings differ by more digits than nodes keep. The yarns must be the same.
bool YarnTable::sameNodes(const YarnTable& other) const {
  if (crossings_ == other.crossings_) return true;
  bool same = true;
  for (const System system : {System::warp, System::weft}) {
    const auto& crossedYarns = of(crossSystem(system)).models;
    for (int own = 0; own < classCount_; ++own)
      for (int crossed = 0; crossed < classCount_; ++crossed) {
        if (!of(system).models[own] || !crossedYarns[crossed]) continue;
        forEachState([&](int state, int otherState) {
          const CellShape::Node at{crossed, true, state, otherState};
          same &= node(system, own, at) == other.node(system, own, at);
        });
      }
  }
  return same;
}

CellStrands YarnTable::strands(const YarnCellKey& key) const {
  const YarnModel& yarn = model(key.system, key.yarn);
  const YarnGeometry& g = yarn.geometry;
  const Stretch stretch = yarn.stretch(key.stretch);
  CellStrands cell = layStrands(yarn, key.previous, key.here, key.next, {key.phase, stretch}, g.pitch_mm);
  const double straight = yarn.straightLength_mm[key.phase] * axisLength_mm(key) / g.cellLength_mm;
  const double mass = stretch.massOfCell(key.phase, g.period);
  const double thicker = mass * straight / cell.length_mm();
  cell.fibreRadius_mm = static_cast<float>(g.fibreRadius_mm * std::sqrt(thicker));
  if (yarn.thinnest() < yarn.thickest()) cell.fibresEach = static_cast<float>(thicker);
  return cell;
}

double YarnTable::axisLength_mm(const YarnCellKey& key) const {
  const double pitch = model(key.system, key.yarn).geometry.pitch_mm;
  const Transition before(key.previous, key.here, spanBetween_mm(key.previous, key.here, pitch));
  const Transition after(key.here, key.next, spanBetween_mm(key.here, key.next, pitch));
  return before.length_mm() - before.lengthTo(0.5 * pitch - key.previous.along_mm) +
         after.lengthTo(0.5 * pitch - key.here.along_mm);
}

}  // namespace loomlight
