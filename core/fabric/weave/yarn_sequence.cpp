#include "core/fabric/weave/yarn_sequence.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/random.h"

namespace loomlight {
namespace {

/// A yarn with its weight, but not `before` where another one has any.
int drawYarn(const std::vector<double>& weights, int before, Random& random) {
  const auto weightOf = [&](int yarn) { return yarn == before ? 0.0 : weights[static_cast<size_t>(yarn)]; };
  const int count = static_cast<int>(weights.size());
  double total = 0;
  for (int yarn = 0; yarn < count; ++yarn) total += weightOf(yarn);
  if (total <= 0) return before;
  double rest = total * random.uniformDouble();
  int last = before;
  for (int yarn = 0; yarn < count; ++yarn) {
    if (weightOf(yarn) <= 0) continue;
    last = yarn;
    if ((rest -= weightOf(yarn)) < 0) break;
  }
  return last;
}

}  // namespace

std::vector<int> mirrored(const std::vector<int>& sequence) {
  std::vector<int> there = sequence;
  if (sequence.size() > 2) there.insert(there.end(), sequence.rbegin() + 1, sequence.rend() - 1);
  return there;
}

std::vector<int> reversed(const std::vector<int>& sequence) {
  return {sequence.rbegin(), sequence.rend()};
}

std::vector<int> repeated(const std::vector<int>& sequence, int times) {
  std::vector<int> result;
  for (int i = 0; i < times; ++i) result.insert(result.end(), sequence.begin(), sequence.end());
  return result;
}

std::vector<int> widened(const std::vector<int>& sequence, int factor) {
  std::vector<int> wide;
  wide.reserve(sequence.size() * static_cast<size_t>(factor));
  for (const int yarn : sequence) wide.insert(wide.end(), static_cast<size_t>(factor), yarn);
  return wide;
}

std::vector<Stripe> stripesOf(const std::vector<int>& sequence) {
  std::vector<Stripe> stripes;
  for (const int yarn : sequence) {
    if (stripes.empty() || stripes.back().yarn != yarn) stripes.push_back({yarn, 0});
    ++stripes.back().width;
  }
  return stripes;
}

std::vector<int> sequenceOf(const std::vector<Stripe>& stripes) {
  std::vector<int> sequence;
  for (const Stripe& stripe : stripes) sequence.insert(sequence.end(), static_cast<size_t>(stripe.width), stripe.yarn);
  return sequence;
}

std::vector<int> balanced(std::vector<int> sequence, int repeat) {
  assert(!sequence.empty() && repeat >= 1);
  const size_t rest = sequence.size() % static_cast<size_t>(repeat);
  if (rest > 0) sequence.insert(sequence.end(), static_cast<size_t>(repeat) - rest, sequence.back());
  return sequence;
}

std::vector<int> randomStripes(const std::vector<double>& weights, const StripeChance& chance) {
  assert(chance.length >= 1 && chance.narrowest >= 1 && chance.narrowest <= chance.widest);
  assert(std::accumulate(weights.begin(), weights.end(), 0.0) > 0);
  Random random(chance.seed);
  const auto length = static_cast<size_t>(chance.length);
  std::vector<int> sequence;
  int yarn = -1;
  while (sequence.size() < length) {
    yarn = drawYarn(weights, yarn, random);
    const auto width = static_cast<size_t>(chance.narrowest) +
                       random.below(static_cast<uint32_t>(chance.widest - chance.narrowest + 1));
    sequence.insert(sequence.end(), std::min(width, length - sequence.size()), yarn);
  }
  return sequence;
}

}  // namespace loomlight
