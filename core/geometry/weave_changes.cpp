#include "core/geometry/weave_changes.h"

namespace loomlight {

std::optional<std::vector<WeavePlace>> weaveChanges(const Weave& before, const Weave& after, size_t limit) {
  if (before.ends() != after.ends() || before.picks() != after.picks()) return std::nullopt;
  std::vector<WeavePlace> changes;
  for (int pick = 0; pick < after.picks(); ++pick) {
    const auto a = before.row(pick), b = after.row(pick);
    if (a.data() == b.data()) continue;
    for (size_t end = 0; end < a.size(); ++end)
      if ((a[end] != 0) != (b[end] != 0)) changes.push_back({pick, static_cast<int>(end)});
    if (changes.size() > limit) return std::nullopt;
  }
  return changes;
}

}  // namespace loomlight
