#include "core/geometry/yarn/migration.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"

// How it works. Each fibre's distance from the ply's axis goes down and up once in a migration, as a raised cosine with
// a phase of its own; each migration is kept as kStages sections. Fibres that are packed would run through one another
// that way, so the sections are relaxed together: every sweep pushes overlapping fibres apart in each section, turned
// and pressed as it lies in the cloth, and then draws each fibre towards the mean of where it is in the sections before
// and after, in the frame that turns along. That pull fades out, so that overlaps have the last word. Between stages a
// fibre follows a Catmull-Rom cubic through its places.

namespace loomlight {
namespace {

constexpr int kSweeps = 100;

/// Of so many turns, spread over the stages: the direction of one stage.
glm::dvec2 directionAt(size_t stage, int turns, size_t stages) {
  const double angle = 2 * kPi * turns * static_cast<double>(stage) / static_cast<double>(stages);
  return {std::cos(angle), std::sin(angle)};
}

void turnAll(std::vector<DiscCentres>& stages, int turns) {
  if (turns == 0) return;
  for (size_t k = 0; k < stages.size(); ++k) {
    const glm::dvec2 direction = directionAt(k, turns, stages.size());
    for (glm::dvec2& p : stages[k]) {
      const PlaceOf<double> place = turned<double>(direction, {p.x, p.y});
      p = {place.up, place.across};
    }
  }
}

constexpr size_t kTogether = kLanes<Float32x8>;  // stages that are parted side by side

/// One stage earlier in each lane; `before`: the eight stages before these.
Float32x8 earlier(Float32x8 before, Float32x8 these) {
  return __builtin_shufflevector(before, these, 7, 8, 9, 10, 11, 12, 13, 14);
}
Float32x8 later(Float32x8 these, Float32x8 after) {
  return __builtin_shufflevector(these, after, 1, 2, 3, 4, 5, 6, 7, 8);
}

/// Every fibre a little towards the mean of where it was and where it will be, as the turning section sees it.
void straighten(std::vector<SectionLanes>& groups, int turns, double share) {
  const size_t count = groups.size();
  const glm::dvec2 on = directionAt(1, turns, kTogether * count), back = directionAt(1, -turns, kTogether * count);
  const auto half = broadcast<Float32x8>(0.5), part = broadcast<Float32x8>(share);
  std::vector<PlaceLanes> way(count);  // of a fibre, as it was
  for (size_t i = 0; i < groups[0].size(); ++i) {
    for (size_t g = 0; g < count; ++g) way[g] = groups[g][i];
    for (size_t g = 0; g < count; ++g) {
      const PlaceLanes &before = way[(g + count - 1) % count], &here = way[g], &after = way[(g + 1) % count];
      const PlaceLanes was = turned<Float32x8>(on, {earlier(before.up, here.up), earlier(before.across, here.across)});
      const PlaceLanes next = turned<Float32x8>(back, {later(here.up, after.up), later(here.across, after.across)});
      groups[g][i].up += part * (half * (was.up + next.up) - here.up);
      groups[g][i].across += part * (half * (was.across + next.across) - here.across);
    }
  }
}

/// As rods that push one another aside: discs apart at every stage, within the rim, and straight from stage to
/// stage, the less so the nearer to the end. Where there is too little room for all, they overlap.
void partFibres(std::vector<DiscCentres>& stages, const HelicalFibres& fibres, int turns, double rim,
                const Task& task) {
  constexpr double kTouching = 0.01;  // overlap, in radii, that counts as none
  static_assert(Migration::kStages % kTogether == 0);
  std::vector<SectionLanes> groups;
  for (size_t k = 0; k < stages.size(); k += kTogether) groups.push_back(sideBySide({&stages[k], kTogether}));
  std::vector<Parting> partings(groups.size(), Parting(fibres));
  std::vector<double> overlaps(groups.size());
  for (int sweep = 0; sweep < kSweeps && !task.stopped(); ++sweep) {
    parallelFor(groups.size(), task.threads, [&](size_t g) {
      overlaps[g] = partings[g].sweep(groups[g]);
      keepWithin(groups[g], rim);
    });
    if (*std::max_element(overlaps.begin(), overlaps.end()) < kTouching * fibres.radius_mm) break;
    straighten(groups, turns, 0.5 * (1 - (sweep + 1.0) / kSweeps));
  }
  for (size_t k = 0; k < stages.size(); ++k) stages[k] = sectionOf(groups[k / kTogether], k % kTogether);
}

/// RMS slope, per pattern, of a wave of unit amplitude with so many periods, as the cubic through its stages has it:
/// that of short waves is less than the wave's own.
double rmsSlope(int periods, int stages) {
  const int steps = 16 * stages;
  const auto wave = [&](double patterns) {
    const Migration::Moment m = Migration::at(patterns, stages);
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += m.weights[i] * std::cos(2 * kPi * periods * (m.first + i) / stages);
    return sum;
  };
  double squares = 0;
  for (int i = 0; i < steps; ++i) {
    const double from = static_cast<double>(i) / steps, to = static_cast<double>(i + 1) / steps;
    squares += std::pow((wave(to) - wave(from)) * steps, 2) / steps;
  }
  return std::sqrt(squares);
}

/// Adds three waves to the way of every fibre, of random lengths and phases, each with a third of the variance of the
/// slope. One fibre in 16 strays more than twice as far.
void stray(std::vector<DiscCentres>& stages, const FibreDisorder& disorder, Random& random) {
  constexpr int kWaves = 3;
  const int count = static_cast<int>(stages.size());
  const int mostPerPattern = count / 3;          // a wave needs three stages to be one
  constexpr double kShortest = 2, kLongest = 9;  // ply radii
  constexpr double kLoopShare = 1.0 / 16, kLoopReach = 2.2;
  const double perRadius = disorder.pattern_mm / disorder.plyRadius_mm;
  const int fewest = std::clamp(static_cast<int>(std::ceil(perRadius / kLongest)), 1, mostPerPattern);
  const int most = std::clamp(static_cast<int>(perRadius / kShortest), fewest, mostPerPattern);
  const double usual = 1 / std::sqrt(1 - kLoopShare + kLoopShare * kLoopReach * kLoopReach);
  std::vector<double> amplitudes;  // of waves, fewest first: each has a third of the variance of the slope
  const double widest_mm = disorder.slope * kLongest * disorder.plyRadius_mm / (std::sqrt(2.0 * kWaves) * kPi);
  for (int periods = fewest; periods <= most; ++periods)
    amplitudes.push_back(usual * std::min(widest_mm, disorder.slope * disorder.pattern_mm /
                                                         (std::sqrt(kWaves) * rmsSlope(periods, count))));
  for (size_t fibre = 0; fibre < stages[0].size(); ++fibre) {
    const double share = random.uniformDouble() < kLoopShare ? kLoopReach : 1.0;
    for (int axis = 0; axis < 2; ++axis)
      for (int wave = 0; wave < kWaves; ++wave) {
        const auto choice = random.below(static_cast<uint32_t>(amplitudes.size()));
        const double turn = 2 * kPi * (fewest + static_cast<int>(choice)) / static_cast<double>(stages.size());
        const double phase = 2 * kPi * random.uniformDouble();
        for (size_t k = 0; k < stages.size(); ++k)
          stages[k][fibre][axis] += share * amplitudes[choice] * std::cos(turn * static_cast<double>(k) + phase);
      }
  }
}

/// Furthest of them from the ply's axis.
double reachOf(const DiscCentres& centres) {
  double square = 0;
  for (const glm::dvec2& p : centres) square = std::max(square, glm::dot(p, p));
  return std::sqrt(square);
}

}  // namespace

Migration::Migration(const DiscCentres& section) {
  keep({section});
}

Migration::Migration(const DiscCentres& section, FibreLayout layout, double amount, const HelicalFibres& fibres,
                     uint64_t seed, const Task& task, const FibreDisorder& disorder, const FibrePattern& pattern) {
  Random random(seed);
  std::vector<double> phases(section.size());
  for (double& phase : phases) phase = random.uniformDouble();
  std::vector<DiscCentres> stages(static_cast<size_t>(kStages * pattern.migrations), section);
  for (size_t k = 0; k < stages.size(); ++k)
    for (size_t i = 0; i < section.size(); ++i)
      stages[k][i] *= 1 - 0.5 * amount * (1 - std::cos(2 * kPi * (static_cast<double>(k) / kStages + phases[i])));
  if (layout == FibreLayout::packed && (amount > 0 || pattern.turns != 0)) {
    turnAll(stages, pattern.turns);
    partFibres(stages, fibres, pattern.turns, reachOf(section), task);
    turnAll(stages, -pattern.turns);
  }
  if (disorder.slope > 0) stray(stages, disorder, random);
  keep(stages);
}

void Migration::keep(const std::vector<DiscCentres>& stages) {
  fibres_ = static_cast<int>(stages[0].size());
  stages_ = static_cast<int>(stages.size());
  for (int i = 0; i < fibres_; ++i)
    for (size_t k = 0; k < stride(); ++k)
      places_.emplace_back(stages[(k + stages.size() - 1) % stages.size()][static_cast<size_t>(i)]);
}

double Migration::reach_mm() const {
  float square = 0;
  for (const glm::vec2& p : places_) square = std::max(square, glm::dot(p, p));
  // Between stages a cubic may swing a little beyond both.
  return std::sqrt(square) + bend_mm() / (8.0 * stages_ * stages_);
}

template <class Visit>
double Migration::largest(const Visit& visit) const {
  if (!moves()) return 0;
  float most = 0;
  for (size_t fibre = 0; fibre < places_.size(); fibre += stride())
    for (int k = 0; k < stages_; ++k) most = std::max(most, visit(&places_[fibre + static_cast<size_t>(k)]));
  return most;
}

double Migration::slope_mm() const {
  return stages_ * largest([](const glm::vec2* p) { return 0.5f * glm::distance(p[0], p[2]); });
}

double Migration::bend_mm() const {
  return static_cast<double>(stages_) * stages_ * largest([](const glm::vec2* p) {
           const glm::vec2 first = p[0] - 2.0f * p[1] + p[2], second = p[1] - 2.0f * p[2] + p[3];
           return std::max(glm::length(2.0f * first - second), glm::length(2.0f * second - first));
         });
}

Migration::Moment Migration::at(double patterns, int stages) {
  const double stage = (patterns - std::floor(patterns)) * stages;
  Moment moment;
  moment.first = std::min(static_cast<int>(stage), stages - 1);
  const auto x = static_cast<float>(stage - moment.first);
  // Catmull and Rom 1974.
  moment.weights[0] = 0.5f * x * (x * (2 - x) - 1);
  moment.weights[1] = 0.5f * (x * x * (3 * x - 5) + 2);
  moment.weights[2] = 0.5f * x * (x * (4 - 3 * x) + 1);
  moment.weights[3] = 0.5f * x * x * (x - 1);
  return moment;
}

}  // namespace loomlight
