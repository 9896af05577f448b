#include "core/fabric/weave/weave_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/period.h"

// How it works. The smallest repeat of the weave is cut into groups of neighbouring ends that weave alike. Where
// each group is the inverse of the one before it, the weave is of the plain kind (1); where each is the one before
// it, so many picks later, it is a twill (2), or a sateen (3) where every end binds once and the step is no
// neighbour's. The code then has the kind, the floats of the first end, the ends of a group, and the step; all other
// weaves have none.

namespace loomlight {
namespace {

using Column = std::vector<uint8_t>;  ///< of an end, pick by pick: whether it is up

constexpr int kMostPicks = 99;
constexpr int64_t kMostCrossings = 1'000'000;  ///< of basic weaves; larger ones are not looked through for a repeat

/// Of the same end, so many picks later.
Column later(const Column& column, int picks) {
  Column shifted = column;
  std::rotate(shifted.rbegin(), shifted.rbegin() + picks, shifted.rend());
  return shifted;
}

Column inverse(Column column) {
  for (uint8_t& up : column) up = !up;
  return column;
}

/// The ends of the smallest repeat, from one that weaves otherwise than the end before it.
std::vector<Column> endsOf(const Weave& weave) {
  std::vector<std::vector<uint8_t>> picks;
  for (int pick = 0; pick < weave.picks(); ++pick) picks.emplace_back(weave.row(pick).begin(), weave.row(pick).end());
  picks = shortestRepeat(std::move(picks));
  std::vector<Column> ends(static_cast<size_t>(weave.ends()));
  for (const std::vector<uint8_t>& pick : picks)
    for (size_t end = 0; end < ends.size(); ++end) ends[end].push_back(pick[end] != 0);
  ends = shortestRepeat(std::move(ends));
  size_t first = 0;
  while (first + 1 < ends.size() && ends[first] == ends[(first + ends.size() - 1) % ends.size()]) ++first;
  std::rotate(ends.begin(), ends.begin() + static_cast<ptrdiff_t>(first), ends.end());
  return ends;
}

/// Ends that weave alike, side by side.
struct EndGroup {
  Column column;
  int ends = 0;
};

std::vector<EndGroup> groupsOf(const std::vector<Column>& ends) {
  std::vector<EndGroup> groups;
  for (const Column& column : ends) {
    if (groups.empty() || groups.back().column != column) groups.push_back({column, 0});
    ++groups.back().ends;
  }
  return groups;
}

/// The pick at which a float above begins; -1 where the thread never changes sides.
int riseOf(const Column& column) {
  const size_t n = column.size();
  for (size_t pick = 0; pick < n; ++pick)
    if (column[pick] && !column[(pick + n - 1) % n]) return static_cast<int>(pick);
  return -1;
}

/// Lengths of its floats, above and below in turn, from the pick where it rises.
std::vector<int> floatsOf(const Column& column) {
  const Column fromRise = later(column, static_cast<int>(column.size()) - riseOf(column));
  std::vector<int> floats;
  for (size_t pick = 0; pick < fromRise.size(); ++pick) {
    if (pick == 0 || fromRise[pick] != fromRise[pick - 1]) floats.push_back(0);
    ++floats.back();
  }
  return floats;
}

bool alternate(const std::vector<EndGroup>& groups) {
  for (size_t i = 1; i < groups.size(); ++i)
    if (groups[i].column != inverse(groups[i - 1].column)) return false;
  return groups.size() % 2 == 0;
}

/// By how many picks each group is behind the one before, all round; 0 where they are not alike.
int stepOf(const std::vector<EndGroup>& groups) {
  const int picks = static_cast<int>(groups[0].column.size());
  for (int step = 1; step < picks; ++step) {
    bool all = true;
    for (size_t i = 0; i < groups.size() && all; ++i)
      all = groups[(i + 1) % groups.size()].column == later(groups[i].column, step);
    if (all) return step;
  }
  return 0;
}

bool bindsOnce(const std::vector<int>& floats) {
  return floats.size() == 2 && (floats[0] == 1 || floats[1] == 1);
}

}  // namespace

std::optional<std::string> isoWeaveCode(const Weave& weave) {
  if (static_cast<int64_t>(weave.ends()) * weave.picks() > kMostCrossings) return std::nullopt;
  const std::vector<Column> columns = endsOf(weave);
  const int picks = static_cast<int>(columns[0].size());
  const std::vector<EndGroup> groups = groupsOf(columns);
  if (picks > kMostPicks || groups.size() < 2 || riseOf(groups[0].column) < 0) return std::nullopt;
  std::vector<int> ends;
  for (const EndGroup& group : groups) ends.push_back(group.ends);
  const bool even = std::equal(ends.begin() + 1, ends.end(), ends.begin());
  if (*std::max_element(ends.begin(), ends.end()) > kMostPicks) return std::nullopt;

  const std::vector<int> floats = floatsOf(groups[0].column);
  int kind = 1, step = 0;
  if (!alternate(groups)) {
    step = even ? stepOf(groups) : 0;
    if (step == 0) return std::nullopt;
    const bool sateen = picks >= 5 && step != 1 && step != picks - 1 && bindsOnce(floats);
    kind = sateen ? 3 : 2;
  }
  if (even) ends.resize(1);
  return fmt::format("{}0-{:02}-{:02}-{:02}", kind, fmt::join(floats, " "), fmt::join(ends, " "), step);
}

}  // namespace loomlight
