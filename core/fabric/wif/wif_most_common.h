#pragma once

#include <algorithm>
#include <map>
#include <vector>

namespace loomlight {

/// What most threads have; `values` not empty. Of several as common the smallest.
template <class Value>
Value mostCommon(const std::vector<Value>& values) {
  std::map<Value, int> counts;
  for (const Value& value : values) ++counts[value];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace loomlight
