#include "core/geometry/yarn/spool.h"

#include <algorithm>
#include <array>

#include "core/base/random.h"
#include "core/base/units.h"

// How it works. Whether the yarn is light or heavy is drawn anew about every evenness cut; a part of the draws is the
// same over a decimetre, which is what shows as streaks in the cloth, as the faults of a drafting frame do. Slubs come
// at random distances. The light and the heavy lie as far apart as gives the coefficient of variation that is asked
// for: it grows in proportion, so it is measured once on the spool itself, with one of a hundred percent. How far
// aside they lie follows from how often each kind of stretch comes.

namespace loomlight {
namespace {

enum State : uint8_t { light, heavy, slub };

constexpr double kLongWave_mm = 100, kLongWaves = 0.35;  ///< of the draws, those that hold for so long

std::vector<uint8_t> drawStates(double stretch_mm, uint64_t seed) {
  const auto run = [stretch_mm](double length_mm) {
    return std::max(1u, static_cast<uint32_t>(length_mm / stretch_mm));
  };
  std::vector<uint8_t> states(Spool::kStretches);
  const auto fill = [&](uint32_t first, uint32_t count, State state) {
    std::fill_n(states.begin() + first, std::min(count, Spool::kStretches - first), state);
  };
  const auto drawn = [](Random& random) { return random.uniform() < 0.5f ? light : heavy; };
  const uint32_t slowRun = run(kLongWave_mm), quickRun = run(kEvennessCut_mm);
  for (uint32_t first = 0; first < Spool::kStretches; first += slowRun) {
    Random slow(hashCombine(~seed, first / slowRun));
    fill(first, slowRun, drawn(slow));
  }
  for (uint32_t first = 0; first < Spool::kStretches; first += quickRun) {
    Random quick(hashCombine(seed, first / quickRun));
    if (quick.uniform() >= kLongWaves) fill(first, quickRun, drawn(quick));
  }
  return states;
}

/// Exponential distances, as between events that know nothing of each other, but a stretch between slubs at least. A
/// slub begins and ends over a stretch each, so at half its height it is as many stretches long as it has ends of
/// stretches.
void addSlubs(const Evenness& evenness, double stretch_mm, uint64_t seed, std::vector<uint8_t>& states) {
  if (evenness.slubs_per_mm <= 0) return;
  Random random(hashCombine(seed, -1));
  const double apart_mm = std::max(0.0, 1 / evenness.slubs_per_mm - evenness.slubLength_mm - stretch_mm);
  const double end_mm = stretch_mm * (Spool::kStretches - 1);
  for (double at_mm = 0;;) {
    at_mm += stretch_mm - apart_mm * std::log1p(-random.uniformDouble());
    const double length_mm = evenness.slubLength_mm * (2 + 2 * random.uniformDouble()) / 3;
    if (at_mm + length_mm > end_mm) return;
    const auto first = static_cast<size_t>(at_mm / stretch_mm);
    const auto ends = std::max<size_t>(1, static_cast<size_t>(std::lround(length_mm / stretch_mm)));
    std::fill_n(states.begin() + static_cast<std::ptrdiff_t>(first), std::min(ends, states.size() - first), slub);
    at_mm += length_mm;
  }
}

double eased(double from, double to, double t, int period) {
  return from == to ? from : from + (to - from) * glm::smoothstep(0.0, period - 1.0, t);
}

/// Coefficient of variation of cuts of a yarn whose mass is 0 where it is light, and 2 where it is heavy: of a cut from
/// each stretch on, which begin in all of its cells by turns.
double variationOfCuts(const std::vector<uint8_t>& states, int period, double cell_mm) {
  constexpr size_t stretches = Spool::kStretches;
  const auto cells = static_cast<size_t>(period);
  const auto kindAt = [&](size_t i) { return static_cast<size_t>(2 * states[i] + states[(i + 1) % stretches]); };
  std::array<std::vector<double>, 4> upTo;  // mass up to a cell, by the states that a stretch goes from and to
  for (size_t kind = 0; kind < upTo.size(); ++kind) {
    const Stretch stretch{kind < 2 ? 0.0f : 2.0f, kind % 2 == 0 ? 0.0f : 2.0f};
    upTo[kind].push_back(0);
    for (int phase = 0; phase < period; ++phase)
      upTo[kind].push_back(upTo[kind].back() + stretch.massOfCell(phase, period));
  }
  std::vector<double> before{0};  // mass up to a stretch
  before.reserve(stretches + 1);
  for (size_t i = 0; i < stretches; ++i) before.push_back(before.back() + upTo[kindAt(i)].back());

  const size_t cut = std::max<size_t>(1, static_cast<size_t>(std::lround(kEvennessCut_mm / cell_mm)));
  double sum = 0, squares = 0, count = 0;
  size_t from = 0, to = cut % cells, last = cut / cells;  // the cells that a cut goes from and to, and its last stretch
  for (size_t i = 0; last < stretches; ++i, ++last, ++count) {
    const double mass = before[last] + upTo[kindAt(last)][to] - before[i] - upTo[kindAt(i)][from];
    sum += mass;
    squares += mass * mass;
    if (++from == cells) {
      from = 0;
      --last;
    }
    if (++to == cells) {
      to = 0;
      ++last;
    }
  }
  const double mean = sum / count;
  return std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean;
}

}  // namespace

double Stretch::massAt(double t, int period) const {
  return eased(from, to, t, period);
}

double Stretch::asideAt_mm(double t, int period) const {
  return eased(asideFrom_mm, asideTo_mm, t, period);
}

double Stretch::twistAt(double t, int period) const {
  if (from == to) return t;
  const double cells = period - 1.0, share = std::clamp(t / cells, 0.0, 1.0);
  return t + twistSwing() * cells * (1 - std::cos(2 * kPi * share)) / (2 * kPi);
}

double Stretch::massOfCell(int phase, int period) const {
  constexpr int kSteps = 8;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += massAt(phase - 0.5 + (i + 0.5) / kSteps, period);
  return sum / kSteps;
}

Spool::Spool(const Evenness& evenness, int period, double cell_mm, uint64_t seed)
    : states_(evenness.slubs_per_mm > 0 ? 3 : 2), stateAt_(drawStates(period * cell_mm, seed)) {
  constexpr double kMostApart = 0.9;  // nothing is lighter than a tenth
  const double apart =
      evenness.massCv > 0 ? std::min(kMostApart, evenness.massCv / variationOfCuts(stateAt_, period, cell_mm)) : 0.0;
  addSlubs(evenness, period * cell_mm, seed, stateAt_);

  const std::array<double, 3> masses{1 - apart, 1 + apart, evenness.slubMass};
  double mean = 0;
  for (const uint8_t state : stateAt_) mean += masses[state] / kStretches;
  for (size_t i = 0; i < masses.size(); ++i) massOf_[i] = static_cast<float>(masses[i] / mean);
  shares_.resize(static_cast<size_t>(kinds()));
  for (uint32_t i = 0; i < kStretches; ++i) shares_[static_cast<size_t>(kind(i))] += 1.0 / kStretches;
  if (evenness.aside_mm > 0) setAside(evenness.aside_mm, period);
}

void Spool::setAside(double rms_mm, int period) {
  // RMS distances. Where nearly all is slubs, which stay in the middle, the few places between would have to lie far
  // beyond the neighbours.
  constexpr double kFarthest = 2;
  const std::array<double, 3> sides{-1, 1, 0};  // light, heavy, slub
  double mean = 0;
  for (const uint8_t state : stateAt_) mean += sides[state] / kStretches;
  double square = 0;
  for (int k = 0; k < kinds(); ++k) {
    const double from = sides[static_cast<size_t>(k / states_)] - mean;
    const double to = sides[static_cast<size_t>(k % states_)] - mean;
    // Mean square over the stretch: eased between the middles of its first and last cells (a smoothstep has the mean
    // 1/2, its square 13/35), and constant for half a cell at either end.
    const double eased = from * to + (to - from) * (to - from) * 13 / 35, constant = 0.5 * (from * from + to * to);
    square += share(k) * ((period - 1) * eased + constant) / period;
  }
  for (size_t i = 0; i < sides.size(); ++i)
    asideOf_mm_[i] =
        static_cast<float>(rms_mm * std::clamp((sides[i] - mean) / std::sqrt(square), -kFarthest, kFarthest));
}

double Spool::farthestAside_mm() const {
  double most = 0;
  for (int i = 0; i < states_; ++i) most = std::max<double>(most, std::abs(asideOf_mm_[i]));
  return most;
}

double Spool::largestRadius() const {
  return std::sqrt(*std::max_element(massOf_, massOf_ + states_));
}

double Spool::smallestRadius() const {
  return std::sqrt(*std::min_element(massOf_, massOf_ + states_));
}

}  // namespace loomlight
