#pragma once

#include <algorithm>
#include <vector>

namespace loomlight {

/// Of n > 0, in order.
inline std::vector<int> divisorsOf(int n) {
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

/// The shortest sequence that goes on in the same way for ever and fits this one a whole number of times.
template <class Value>
std::vector<Value> shortestRepeat(std::vector<Value> sequence) {
  const auto same = [&](int a, int b) { return sequence[static_cast<size_t>(a)] == sequence[static_cast<size_t>(b)]; };
  sequence.resize(static_cast<size_t>(smallestPeriod(static_cast<int>(sequence.size()), same)));
  return sequence;
}

}  // namespace loomlight
