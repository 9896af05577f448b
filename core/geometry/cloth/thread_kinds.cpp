#include "core/geometry/cloth/thread_kinds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/period.h"
#include "core/fabric/model/thread_spacing.h"

namespace loomlight {
namespace {

ThreadKinds evenKinds(const std::vector<int>& classes) {
  ThreadKinds even;
  even.kinds.resize(static_cast<size_t>(*std::max_element(classes.begin(), classes.end())) + 1);
  for (size_t i = 0; i < even.kinds.size(); ++i) even.kinds[i].geometryClass = static_cast<int>(i);
  even.sequence = shortestRepeat(classes);
  return even;
}

/// How much of these displacements, in pitches, the threads have room for.
double shareOf(const std::vector<int>& classes, const std::vector<double>& displaced, double pitch_mm,
               const LeastDistance& least_mm) {
  const double farthest = *std::max_element(displaced.begin(), displaced.end());
  double share = std::min(1.0, kMostDisplaced / farthest);
  const size_t threads = std::lcm(classes.size(), displaced.size());
  for (size_t i = 0; i < threads; ++i) {
    const double closer = displaced[i % displaced.size()] - displaced[(i + 1) % displaced.size()];
    if (closer <= 0) continue;
    const double least = least_mm(classes[i % classes.size()], classes[(i + 1) % classes.size()]) / pitch_mm;
    share = std::min(share, std::max(0.0, 1 - least) / closer);
  }
  return share;
}

}  // namespace

double ThreadKinds::farthest_mm() const {
  double farthest = 0;
  for (const ThreadKind& kind : kinds) farthest = std::max<double>(farthest, std::abs(kind.displaced_mm));
  return farthest;
}

ThreadKinds threadKinds(const std::vector<int>& classes, const std::vector<double>& spacing, double pitch_mm,
                        const LeastDistance& least_mm) {
  ThreadKinds even = evenKinds(shortestRepeat(classes));
  const std::vector<double> displaced = displacements(spacing);
  if (displaced.empty()) return even;
  ThreadKinds spaced;
  spaced.share = shareOf(even.sequence, displaced, pitch_mm, least_mm);
  even.share = 0;
  constexpr double kHardly = 1e-3;
  if (spaced.share < kHardly) return even;
  std::map<std::pair<int, double>, int> numbers;
  const size_t threads = std::lcm(even.sequence.size(), displaced.size());
  for (size_t i = 0; i < threads; ++i) {
    const int geometryClass = even.sequence[i % even.sequence.size()];
    const double by = displaced[i % displaced.size()];
    const auto [entry, isNew] = numbers.try_emplace({geometryClass, by}, static_cast<int>(numbers.size()));
    if (isNew) spaced.kinds.push_back({geometryClass, static_cast<float>(spaced.share * by * pitch_mm)});
    spaced.sequence.push_back(entry->second);
  }
  if (spaced.kinds.size() > static_cast<size_t>(kMaxThreadKinds)) return even;
  spaced.sequence = shortestRepeat(std::move(spaced.sequence));
  return spaced;
}

}  // namespace loomlight
