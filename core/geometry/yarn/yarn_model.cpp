#include "core/geometry/yarn/yarn_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/random.h"
#include "core/fabric/model/validate.h"
#include "core/geometry/yarn/cell_strands.h"
#include "core/geometry/yarn/cross_section.h"
#include "core/geometry/yarn/stations.h"

// How it works. The number of fibres, where it is not given, follows from the count, less what hairs weigh. The fibres
// of a ply are laid in a section with the room that they need wherever the yarn goes, parted until none overlap, and
// given ways to migrate on (cross_section.h, migration.h); every ply has its own section. Straight cells are then laid
// and measured, and the fibres' radius is set so that their length weighs just what the yarn does. How much room they
// need depends on that radius: a first estimate of it comes from fibres that are laid the same way but not parted.

namespace loomlight {
namespace {

constexpr double kFlyawayShare = 0.25;  // of the length of all fibres, at most
constexpr double kMigrationsPerTurn =
    0.7;  // Zhao's fits lie between 0.1 and 1.9; not whole, or fibres only shift aside

int migrations(const YarnGeometry& g) {
  if (g.migration <= 0 && g.disorder <= 0) return 0;
  const int turns = std::max({std::abs(g.plyTurns), std::abs(g.plyTurns + g.yarnTurns), std::abs(g.fibreSpin())});
  return std::max(1, static_cast<int>(std::lround(kMigrationsPerTurn * turns)));
}

constexpr double kFullest = 0.82;  // what leaves discs in disorder (random close packing)

/// The sections that a yarn's fibres lie in on its way, with halfway between two crossings.
std::vector<SectionScale> sectionsOf(const YarnGeometry& g) {
  std::vector<SectionScale> sections;
  for (const SectionOutline& pressed : g.pressed) {
    sections.push_back(g.withinOutline(pressed));
    sections.push_back(g.withinOutline(SectionEasing(pressed, pressed, g.free).at(0.5)));
  }
  return sections;
}

/// The room that packed fibres keep in a section: they lie apart in all sections that the yarn has on its way, and
/// their chords lie inside the curve, so that halfway between stations the section is narrower. But no more than leaves
/// them in disorder.
HelicalFibres roomOfFibres(const YarnGeometry& g, const SectionScale& section) {
  HelicalFibres fibres{g.fibreRadius_mm, g.fibreSpin() / (g.period * g.cellLength_mm), section};
  double least = 1;
  for (const SectionScale& other : sectionsOf(g))
    least = std::min({least, other.up / section.up, other.across / section.across});
  fibres.radius_mm /= least;
  if (fibres.turns_per_mm != 0) fibres.radius_mm *= 1 + kSagitta * g.fibreRadius_mm / g.plyRadius_mm;
  const double area = section.up * section.across;
  const double typicalCosine = fibres.cosineAt(0.5 * area * g.plyRadius_mm * g.plyRadius_mm);
  const double fullest = g.plyRadius_mm * std::sqrt(kFullest * area * typicalCosine / g.fibresPerPly);
  fibres.radius_mm = std::max(g.fibreRadius_mm, std::min(fibres.radius_mm, fullest));
  return fibres;
}

/// The same fibres, to be laid in the round section with as much room.
HelicalFibres asRound(const HelicalFibres& fibres) {
  const double scale = std::sqrt(fibres.section.up * fibres.section.across);
  return {fibres.radius_mm / scale, fibres.turns_per_mm, {}};
}

/// How the fibres of a ply are laid: the section that they are parted in, and after what their ways repeat.
struct PlyLayout {
  SectionScale section;
  FibrePattern pattern;
  int patterns = 0;  ///< in a period; 0: their places stay
  int stages() const { return patterns == 0 ? 1 : Migration::kStages * pattern.migrations; }
};

/// Packed fibres are parted in the usual section, turning in it as they do in the yarn. Where the pattern is too long
/// they are parted round, with the room that they need any way round. So are those of plies, which turn differently,
/// with the room that the section leaves: plies that grow would stand into other yarns.
PlyLayout layoutOf(const YarnGeometry& g, FibreLayout onTheirWay) {
  constexpr int kMostPlaces = 150'000;
  const int migrating = migrations(g), turns = g.fibreSpin();
  PlyLayout layout;
  const SectionScale usual = g.withinOutline(g.usual());
  if (onTheirWay == FibreLayout::packed && g.singles() == 1 && g.fibresPerPly > 1) {
    layout.section = usual;
    layout.patterns = std::gcd(migrating, turns);
    if (layout.patterns == 0) return layout;
    layout.pattern = {std::max(1, migrating / layout.patterns), turns / layout.patterns};
    if (layout.stages() * g.fibresPerPly <= kMostPlaces) return layout;
  }
  const double round = g.singles() > 1 ? std::sqrt(usual.up * usual.across) : std::min(usual.up, usual.across);
  return {{round, round}, {}, migrating};
}

/// Of the outermost fibres, wherever in its ply one starts, and the ply in its cord.
RateBounds ratesOfTwist(const YarnModel& m) {
  constexpr int kAngles = 24;
  constexpr double kBetween = 1.02;  // the most between two of the angles, over that at one
  const YarnGeometry& g = m.geometry;
  const PlyShape plyShape = g.plyShape(), cordShape = g.cordShape();
  const int inPly = g.singles() > 1 ? kAngles : 1, inCord = g.plies > 1 && g.cords > 1 ? kAngles : 1;
  RateBounds most;
  for (int i = 0; i < inPly; ++i)
    for (int k = 0; k < inCord; ++k) {
      const Motion still{m.plyReach_mm * glm::dvec2(directionOf(i, inPly))};
      const Motion ply = plyShape.place(still.turning(g.plyTurns)).turning(g.yarnTurns);
      const Motion fibre = cordShape.place(turned(directionOf(k, inCord), ply)).turning(g.cableTurns);
      most.slope = std::max(most.slope, kBetween * glm::length(fibre.velocity));
      most.bend = std::max(most.bend, kBetween * glm::length(fibre.acceleration));
    }
  return most;
}

/// Sets how far the fibres reach, and how they move, of plies that reach so far from their middle.
void setReach(YarnModel& m, double plyReach_mm) {
  const PlyShape plyShape = m.geometry.plyShape(), cordShape = m.geometry.cordShape();
  m.plyReach_mm = plyReach_mm;
  m.bodyReach_mm = m.geometry.reach_mm(plyReach_mm);
  m.twisting = ratesOfTwist(m);
  m.wandering = {};
  const double stretched = plyShape.stretch(plyReach_mm) * cordShape.stretch(plyShape.reach_mm(plyReach_mm));
  for (const Migration& ply : m.plies) {
    m.wandering.slope = std::max(m.wandering.slope, stretched * ply.slope_mm());
    m.wandering.bend = std::max(m.wandering.bend, stretched * ply.bend_mm());
  }
  m.shapeBend_per_mm = plyShape.bend_per_mm() + cordShape.bend_per_mm();
}

/// `sketched`: packed fibres are not parted, which is most of the work.
void laySections(YarnModel& m, bool sketched, const Task& task) {
  const YarnGeometry& g = m.geometry;
  const FibreLayout onTheirWay = sketched ? FibreLayout::random : g.layout;
  const PlyLayout layout = layoutOf(g, onTheirWay);
  HelicalFibres fibres = roomOfFibres(g, layout.section);
  if (sketched) fibres.radius_mm *= 0.1;  // thin fibres hardly have to be parted
  m.patterns = layout.patterns;
  const double pattern_mm = g.period * g.cellLength_mm / std::max(1, m.patterns);
  m.plies.clear();
  double plyReach_mm = 0;
  for (int ply = 0; ply < g.plies; ++ply) {
    const uint64_t seed = hashCombine(g.seed, ply);
    const DiscCentres section =
        plySection(g.layout, g.fibresPerPly, g.plyRadius_mm, m.patterns == 0 ? fibres : asRound(fibres), seed, task);
    m.plies.push_back(m.patterns == 0 ? Migration(section)
                                      : Migration(section, onTheirWay, g.migration, fibres, hashCombine(seed, 1), task,
                                                  {g.disorder, pattern_mm, g.plyRadius_mm}, layout.pattern));
    plyReach_mm = std::max(plyReach_mm, m.plies.back().reach_mm());
  }
  setReach(m, plyReach_mm);
}

void placeLooseFibres(YarnModel& m, double budget_mm) {
  const YarnGeometry& g = m.geometry;
  if (g.hairiness_per_mm > 0 || g.wrappers_per_mm > 0) m.flyaways = placeFlyaways(g, budget_mm);
  m.flyawaysAt.resize(static_cast<size_t>(g.period));
  for (int phase = 0; phase < g.period; ++phase)
    for (size_t i = 0; i < m.flyaways.size(); ++i)
      for (const double shift : {-1.0 * g.period, 0.0, 1.0 * g.period})
        if (m.flyaways[i].start + shift < phase + 1 && m.flyaways[i].end + shift > phase - 1)
          m.flyawaysAt[phase].push_back({static_cast<int>(i), shift});
}

/// Length of the loose fibres of a period, were the yarn straight.
double looseLength_mm(const YarnModel& m) {
  double total = 0;
  for (const Flyaway& f : m.flyaways) {
    const int steps = 16 + static_cast<int>(2 * std::abs(f.angleSpan));  // six to a turn, and a few
    const AxisPosition straight{0, 0, 0, m.geometry.withinOutline(m.geometry.usual())};
    for (int i = 0; i < steps; ++i) {
      const auto at = [&](int k) { return f.start + (f.end - f.start) * k / steps; };
      const glm::dvec2 d =
          flyawayOffset(f, m.geometry, at(i + 1), straight) - flyawayOffset(f, m.geometry, at(i), straight);
      const double ds = (at(i + 1) - at(i)) * m.geometry.cellLength_mm;
      total += std::sqrt(glm::dot(d, d) + ds * ds);
    }
  }
  return total;
}

/// Fibres a ply that a cell has room for in memory, at the stations it needs.
int fibreLimit(const YarnModel& m) {
  const PathNode straight = m.straightNode();
  const size_t stations = layStations(m, straight, straight, straight, {}, m.geometry.cellLength_mm).size();
  const int byPoints = kMaxPointsPerCell / (m.geometry.singles() * static_cast<int>(stations));
  return std::clamp(byPoints, 1, std::min(kMaxFibresPerPly, kMaxFibresInYarn / m.geometry.singles()));
}

void spin(YarnModel& m) {
  const YarnGeometry& g = m.geometry;
  m.spool = g.evenness.isEven() ? nullptr : std::make_shared<Spool>(g.evenness, g.period, g.cellLength_mm, g.seed);
}

/// YarnModel::separation, of the fibres of a ply as its neighbours flatten it. Packed fibres that keep their places lie
/// in order, and touch: that their gaps are alike makes up for what they overlap where they touch (a dense satin lets
/// through up to 25 % too much if it is counted).
double separationOf(const YarnModel& m) {
  constexpr int kMoments = 8;  // of a pattern
  const YarnGeometry& g = m.geometry;
  if (g.layout == FibreLayout::packed && g.migration <= 0 && g.disorder <= 0 && g.singles() == 1 && !m.source.sketched)
    return 1;
  const SectionScale usual = g.withinOutline(g.usual());
  const HelicalFibres fibres{g.fibreRadius_mm, g.fibreSpin() / (g.period * g.cellLength_mm), usual};
  const PlyShape shape = g.plyShape();
  const glm::vec2 middle(static_cast<float>(shape.orbit_mm()), 0);
  double overlap = 0;
  DiscCentres centres(static_cast<size_t>(g.fibresPerPly));
  for (const Migration& ply : m.plies)
    for (int moment = 0; moment < kMoments; ++moment) {
      const Migration::Moment at = ply.at((moment + 0.5) / kMoments);
      const glm::vec2 inPly = directionOf(moment, kMoments), inYarn = directionOf(3 * moment, kMoments);
      for (int i = 0; i < ply.fibres(); ++i) {
        const glm::vec2 place = turned(inPly, ply.moves() ? ply.place(i, at) : ply.place(i));
        centres[static_cast<size_t>(i)] = turned(inYarn, shape.place(place) - middle);
      }
      overlap += meanOverlap(centres, fibres) / (kMoments * static_cast<double>(m.plies.size()));
    }
  const double room = g.plyRadius_mm * g.plyRadius_mm * usual.up * usual.across;
  const double filled = g.fibresPerPly * g.fibreRadius_mm * g.fibreRadius_mm / room;
  return std::clamp(1 - overlap / filled, 0.0, 1.0);
}

void measureStraight(YarnModel& m) {
  const PathNode straight = m.straightNode();
  m.straightLength_mm.clear();
  for (int phase = 0; phase < m.geometry.period; ++phase)
    m.straightLength_mm.push_back(
        layStrands(m, straight, straight, straight, {phase, {}}, m.geometry.cellLength_mm).length_mm());
}

/// Fibre length per length of yarn.
double meanTakeUp(const YarnModel& m) {
  double total = 0;
  for (const double length : m.straightLength_mm) total += length;
  return total / (m.geometry.period * m.geometry.cellLength_mm);
}

}  // namespace

double YarnModel::reachUp_mm() const {
  // A thicker place also lies further out, by as much (CellStations::place).
  const double scale = geometry.highest() * thickest();
  double reach = bodyReach_mm * scale;
  for (const Flyaway& f : flyaways)
    reach = std::max(reach, f.lies ? thickest() * geometry.halfHeight_mm() + f.rise_mm : f.root_mm * scale + f.rise_mm);
  return reach + (thickest() - 1) * geometry.halfHeight_mm() + 1.05 * thickest() * geometry.fibreRadius_mm;
}

YarnSource sourceOf(const YarnGeometry& resolved, const Yarn& yarn, const Fibre& fibre) {
  return {resolved, fibre.radius_um, fibre.density_g_cm3, yarn.count_tex, yarn.fibresPerPly};
}

bool isWorthSketching(const YarnSource& source) {
  constexpr double kMany = 4000;  // places of fibres, all stages of a migration counted: some 20 ms of parting
  const YarnGeometry& g = source.resolved;
  const double radius = source.fibreRadius_um * kMmPerUm;
  const double inYarn = source.count_tex * 1e-3 / (source.fibreDensity_g_cm3 * kPi * radius * radius);
  const double fibres = source.fibresPerPly ? static_cast<double>(*source.fibresPerPly) * g.plies : inYarn / g.cords;
  return g.layout == FibreLayout::packed && fibres * (g.migration > 0 ? Migration::kStages : 1) > kMany;
}

std::shared_ptr<const YarnModel> makeYarnModel(const YarnSource& source, const Task& task) {
  auto model = std::make_shared<YarnModel>();
  model->source = source;
  YarnGeometry& g = model->geometry;
  g = source.resolved;
  g.evenness = {};  // fibres lie where they would in an even yarn of an even sett
  const double radius = source.fibreRadius_um * kMmPerUm;
  const double fibreArea = kPi * radius * radius;
  const double takeUp = estimateTakeUp(g, twistOf(g));
  // Section of all fibres cut square to each, mm^2: the linear density over the fibres' own.
  const double area = source.fibresPerPly ? *source.fibresPerPly * g.singles() * takeUp * fibreArea
                                          : source.count_tex * 1e-3 / source.fibreDensity_g_cm3;

  g.fibreRadius_mm = radius;
  model->patterns = migrations(g);
  setReach(*model, g.plyRadius_mm);
  placeLooseFibres(*model, kFlyawayShare * area / fibreArea * g.period * g.cellLength_mm);
  const double loose = looseLength_mm(*model) / (g.period * g.cellLength_mm);
  const int limit = fibreLimit(*model);
  const double wanted =
      source.fibresPerPly ? *source.fibresPerPly : (area / fibreArea - loose) / (g.singles() * takeUp);
  g.fibresPerPly = std::clamp(static_cast<int>(std::lround(std::min(wanted, 1e6))), 1, limit);

  const auto lay = [&](bool sketched) {
    g.rim_mm = g.monofilament ? 0.0 : std::min(g.fibreRadius_mm, 0.5 * g.plyRadius_mm);
    laySections(*model, sketched, task);
    measureStraight(*model);
    if (!source.fibresPerPly) g.fibreRadius_mm = std::sqrt(area / (kPi * meanTakeUp(*model)));
  };
  if (source.fibresPerPly) {
    g.fibreRadius_mm = radius * std::sqrt(static_cast<double>(*source.fibresPerPly) / g.fibresPerPly);
  } else {
    g.fibreRadius_mm = std::sqrt(area / (kPi * (g.singles() * g.fibresPerPly * takeUp + loose)));
    // The sections of packed yarns depend on the radius, the radius on the take-up of the sections. A sketch of them
    // knows it to a half of a percent or so (1.4 % of a voile), less than the clearance of the packing.
    if (!source.sketched) lay(true);
  }
  lay(source.sketched);
  g.count_tex = 1e6 * g.fibreMass_g_mm() * meanTakeUp(*model);
  model->separation = separationOf(*model);
  g.evenness = source.resolved.evenness;
  spin(*model);
  return model;
}

std::shared_ptr<const YarnModel> withEvenness(const YarnModel& model, const Evenness& evenness) {
  auto other = std::make_shared<YarnModel>(model);
  other->source.resolved.evenness = other->geometry.evenness = evenness;
  spin(*other);
  return other;
}

}  // namespace loomlight
