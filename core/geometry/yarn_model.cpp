#include "core/geometry/yarn_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/fabric/model/validate.h"
#include "core/geometry/cell_strands.h"
#include "core/geometry/cross_section.h"
#include "core/geometry/stations.h"

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

/// The room that packed fibres keep in their section. Flattened, it is lower by upScale(), and they turn in it, so all
/// ways round they need the room that they have least of; and their chords lie inside the curve, so that halfway
/// between stations the section is narrower. But no more than leaves discs in disorder (random close packing).
HelicalFibres roomOfFibres(const YarnModel& m) {
  constexpr double kFullest = 0.82;
  const YarnGeometry& g = m.geometry;
  HelicalFibres fibres{g.fibreRadius_mm, g.fibreSpin() / (g.period * g.cellLength_mm)};
  fibres.radius_mm /= std::min(m.upScale(), m.acrossScale());
  if (fibres.turns_per_mm != 0) fibres.radius_mm *= 1 + kSagitta * g.fibreRadius_mm / g.plyRadius_mm;
  const double typicalCosine = fibres.cosineAt(0.5 * g.plyRadius_mm * g.plyRadius_mm);
  const double fullest = g.plyRadius_mm * std::sqrt(kFullest * typicalCosine / g.fibresPerPly);
  fibres.radius_mm = std::max(g.fibreRadius_mm, std::min(fibres.radius_mm, fullest));
  return fibres;
}

void laySections(YarnModel& m, const Task& task) {
  const YarnGeometry& g = m.geometry;
  HelicalFibres fibres = roomOfFibres(m);
  if (m.source.sketched) fibres.radius_mm *= 0.1;  // thin threads hardly have to be parted
  const FibreLayout onTheirWay = m.source.sketched ? FibreLayout::random : g.layout;
  const double migration_mm = g.period * g.cellLength_mm / std::max(1, m.migrations);
  m.plies.clear();
  m.bodyReach_mm = 0;
  for (int ply = 0; ply < g.plies; ++ply) {
    const uint64_t seed = hashCombine(g.seed, ply);
    const DiscCentres section = plySection(g.layout, g.fibresPerPly, g.plyRadius_mm, fibres, seed, task);
    m.plies.push_back(m.migrations == 0 ? Migration(section)
                                        : Migration(section, onTheirWay, g.migration, fibres, hashCombine(seed, 1),
                                                    task, {g.disorder, migration_mm, g.plyRadius_mm}));
    m.bodyReach_mm = std::max(m.bodyReach_mm, g.cordOrbit_mm + g.plyOrbit_mm + m.plies.back().reach_mm());
  }
}

void placeLooseFibres(YarnModel& m, double budget_mm) {
  const YarnGeometry& g = m.geometry;
  if (g.hairiness_per_mm > 0) m.flyaways = placeFlyaways(g, budget_mm);
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
    constexpr int kSteps = 16;
    for (int i = 0; i < kSteps; ++i) {
      const auto at = [&](int k) { return f.start + (f.end - f.start) * k / kSteps; };
      const glm::dvec2 d = flyawayOffset(f, m.geometry, at(i + 1), {}) - flyawayOffset(f, m.geometry, at(i), {});
      const double ds = (at(i + 1) - at(i)) * m.geometry.cellLength_mm;
      total += std::sqrt(glm::dot(d, d) + ds * ds);
    }
  }
  return total;
}

/// Fibres a ply that a cell has room for in memory, at the stations it needs.
int fibreLimit(const YarnModel& m) {
  const PathNode straight;
  const size_t stations = layStations(m, straight, straight, straight, 0, m.geometry.cellLength_mm).size();
  const int byPoints = kMaxPointsPerCell / (m.geometry.singles() * static_cast<int>(stations));
  return std::clamp(byPoints, 1, std::min(kMaxFibresPerPly, kMaxFibresInYarn / m.geometry.singles()));
}

void measureStraight(YarnModel& m) {
  const PathNode straight;
  m.straightLength_mm.clear();
  for (int phase = 0; phase < m.geometry.period; ++phase)
    m.straightLength_mm.push_back(
        layStrands(m, straight, straight, straight, phase, m.geometry.cellLength_mm).length_mm());
}

/// Fibre length per length of yarn.
double meanTakeUp(const YarnModel& m) {
  double total = 0;
  for (const double length : m.straightLength_mm) total += length;
  return total / (m.geometry.period * m.geometry.cellLength_mm);
}

}  // namespace

double YarnModel::reachUp_mm() const {
  double reach = bodyReach_mm * upScale();
  const double scale = upScale();
  for (const Flyaway& f : flyaways)
    reach = std::max(reach, f.lies ? geometry.halfHeight_mm + f.rise_mm : f.root_mm * scale + f.rise_mm);
  return reach + 1.05 * geometry.fibreRadius_mm;
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
  const double radius = source.fibreRadius_um * kMmPerUm;
  const double fibreArea = kPi * radius * radius;
  const double takeUp = estimateTakeUp(g, twistOf(g));
  // Section of all fibres cut square to each, mm^2: the linear density over the fibres' own.
  const double area = source.fibresPerPly ? *source.fibresPerPly * g.singles() * takeUp * fibreArea
                                          : source.count_tex * 1e-3 / source.fibreDensity_g_cm3;

  g.fibreRadius_mm = radius;
  model->migrations = migrations(g);
  model->bodyReach_mm = 0.5 * g.diameter_mm();
  placeLooseFibres(*model, kFlyawayShare * area / fibreArea * g.period * g.cellLength_mm);
  const double loose = looseLength_mm(*model) / (g.period * g.cellLength_mm);
  const int limit = fibreLimit(*model);
  const double wanted =
      source.fibresPerPly ? *source.fibresPerPly : (area / fibreArea - loose) / (g.singles() * takeUp);
  g.fibresPerPly = std::clamp(static_cast<int>(std::lround(std::min(wanted, 1e6))), 1, limit);

  // The sections of packed yarns depend on the radius, the radius on the take-up of the sections: the second round
  // changes it by a few parts in ten thousand, far less than the clearance of the packing.
  for (int round = 0; round < (source.sketched ? 1 : 2); ++round) {
    if (source.fibresPerPly)
      g.fibreRadius_mm = radius * std::sqrt(static_cast<double>(*source.fibresPerPly) / g.fibresPerPly);
    else if (round == 0)
      g.fibreRadius_mm = std::sqrt(area / (kPi * (g.singles() * g.fibresPerPly * takeUp + loose)));
    laySections(*model, task);
    measureStraight(*model);
    if (!source.fibresPerPly) g.fibreRadius_mm = std::sqrt(area / (kPi * meanTakeUp(*model)));
  }
  g.count_tex = 1e6 * g.fibreMass_g_mm() * meanTakeUp(*model);
  return model;
}

}  // namespace loomlight
