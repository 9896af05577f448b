#include "core/geometry/cloth/weave_changes.h"

#include <algorithm>

namespace loomlight {

std::optional<std::vector<WeaveCrossing>> weaveChanges(const Weave& before, const Weave& after, size_t limit) {
  const auto ends = static_cast<size_t>(std::min(before.ends(), after.ends()));
  std::vector<WeaveCrossing> changes;
  for (int pick = 0; pick < std::min(before.picks(), after.picks()); ++pick) {
    if (before.sharedRow(pick) == after.sharedRow(pick)) continue;  // not even looked at: they may lie anywhere
    const auto a = before.row(pick).first(ends), b = after.row(pick).first(ends);
    if (std::equal(a.begin(), a.end(), b.begin())) continue;
    for (size_t end = 0; end < ends; ++end)
      if ((a[end] != 0) != (b[end] != 0)) changes.push_back({pick, static_cast<int>(end)});
    if (changes.size() > limit) return std::nullopt;
  }
  return changes;
}

}  // namespace loomlight
