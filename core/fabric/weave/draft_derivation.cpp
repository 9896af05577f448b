#include "core/fabric/weave/draft_derivation.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>
#include <unordered_map>

// How it works. Picks of equal rows share a treadle. Ends that go together in all picks share a shaft: they start as
// one class, and each distinct pick splits every class into the ends that it raises and those that it leaves; the
// classes that are left at the end are the shafts, and fewer cannot do. A jacquard is told by its first picks, which
// already need too many.

namespace loomlight {
namespace {

/// The picks that differ, in the order in which they come first, and which of them each pick is.
struct Sheds {
  std::vector<int> firstPicks;
  std::vector<int> shedOfPick;
};

Sheds distinctPicks(const Weave& weave) {
  Sheds sheds;
  std::unordered_map<std::string_view, int> known;
  for (int pick = 0; pick < weave.picks(); ++pick) {
    const std::span<const uint8_t> row = weave.row(pick);
    const std::string_view bytes(reinterpret_cast<const char*>(row.data()), row.size());
    const auto [position, isNew] = known.emplace(bytes, static_cast<int>(sheds.firstPicks.size()));
    if (isNew) sheds.firstPicks.push_back(pick);
    sheds.shedOfPick.push_back(position->second);
  }
  return sheds;
}

/// Which ends go together over all of `picks`: a class for each end, numbered from 0 as they come first. Each pick
/// splits the classes that it does not lift as one. Given up, with a count beyond it, when they are more than `most`.
std::vector<int> classesOfEnds(const Weave& weave, const std::vector<int>& picks, int most, int& count) {
  std::vector<int> classOf(static_cast<size_t>(weave.ends()), 0);
  count = 1;
  for (const int pick : picks) {
    std::vector<int> split(2 * static_cast<size_t>(count), -1);
    int next = 0;
    for (size_t end = 0; end < classOf.size(); ++end) {
      int& to = split[2 * static_cast<size_t>(classOf[end]) + weave.at(pick, static_cast<int>(end))];
      if (to < 0) to = next++;
      classOf[end] = to;
    }
    count = next;
    if (count > most) break;
  }
  return classOf;
}

}  // namespace

Draft smallestDraft(const Weave& weave) {
  return *smallestDraft(weave, weave.ends());
}

std::optional<Draft> smallestDraft(const Weave& weave, int mostShafts) {
  // The first picks tell a jacquard, before all of its picks are compared with each other.
  constexpr int kTellingPicks = 64;
  std::vector<int> firstPicks(static_cast<size_t>(std::min(weave.picks(), kTellingPicks)));
  std::iota(firstPicks.begin(), firstPicks.end(), 0);
  Draft draft;
  classesOfEnds(weave, firstPicks, mostShafts, draft.shafts);
  if (draft.shafts > mostShafts) return std::nullopt;

  const Sheds sheds = distinctPicks(weave);
  const std::vector<int> shaftOfEnd = classesOfEnds(weave, sheds.firstPicks, mostShafts, draft.shafts);
  if (draft.shafts > mostShafts) return std::nullopt;
  draft.treadles = static_cast<int>(sheds.firstPicks.size());
  std::vector<int> endOfShaft(static_cast<size_t>(draft.shafts), -1);
  for (size_t end = 0; end < shaftOfEnd.size(); ++end) {
    draft.threading.push_back({shaftOfEnd[end] + 1});
    endOfShaft[shaftOfEnd[end]] = static_cast<int>(end);
  }
  for (const int pick : sheds.firstPicks) {
    std::vector<int>& tied = draft.tieUp.emplace_back();
    for (int shaft = 0; shaft < draft.shafts; ++shaft)
      if (weave.at(pick, endOfShaft[shaft])) tied.push_back(shaft + 1);
  }
  for (const int shed : sheds.shedOfPick) draft.treadling.push_back({shed + 1});
  return draft;
}

namespace {

size_t picksOf(const Draft& draft) {
  return draft.liftplan.empty() ? draft.treadling.size() : draft.liftplan.size();
}

/// The shafts from 1 to `shafts` that are not among `some`, which is sorted.
std::vector<int> otherShafts(const std::vector<int>& some, int shafts) {
  std::vector<int> others;
  auto next = some.begin();
  for (int shaft = 1; shaft <= shafts; ++shaft) {
    while (next != some.end() && *next < shaft) ++next;
    if (next == some.end() || *next != shaft) others.push_back(shaft);
  }
  return others;
}

/// The shafts that are up in a pick, sorted.
std::vector<int> raisedShafts(const Draft& draft, size_t pick) {
  std::vector<int> pulled = pulledShafts(draft, pick);
  const bool up = draft.risingShed || !draft.liftplan.empty();
  return up ? pulled : otherShafts(pulled, draft.shafts);
}

/// Each pick presses one treadle that there is, so that a treadle can be tied otherwise without touching another pick.
bool pressesOneTreadle(const Draft& draft) {
  return std::all_of(draft.treadling.begin(), draft.treadling.end(), [&](const std::vector<int>& pressed) {
    return pressed.size() == 1 && pressed[0] >= 1 && static_cast<size_t>(pressed[0]) <= draft.tieUp.size();
  });
}

/// An end on several shafts goes with whichever of them moves, so "raise these" cannot be said as "pull the others
/// down" of it, nor the reverse.
bool swapsUpAndDown(const Draft& draft) {
  return std::all_of(draft.threading.begin(), draft.threading.end(),
                     [](const std::vector<int>& shafts) { return shafts.size() <= 1; });
}

/// The draft, or one of the same cloth that has each end on one shaft, in a rising shed.
Draft swappable(const Draft& draft) {
  return swapsUpAndDown(draft) ? draft : smallestDraft(drawdown(draft));
}

}  // namespace

Draft withLiftplan(Draft draft) {
  if (draft.liftplan.empty() && !draft.risingShed) draft = swappable(draft);
  NumberLists liftplan;
  for (size_t pick = 0; pick < picksOf(draft); ++pick) liftplan.push_back(raisedShafts(draft, pick));
  draft.liftplan = std::move(liftplan);
  draft.tieUp.clear();
  draft.treadling.clear();
  draft.treadles = 0;
  return draft;
}

Draft withTreadles(const Draft& draft) {
  if (!draft.liftplan.empty() && !draft.risingShed && !swapsUpAndDown(draft))
    return withShed(smallestDraft(drawdown(draft)), false);
  std::map<std::vector<int>, int> treadleOfLift;
  Draft treadled = draft;
  treadled.liftplan.clear();
  treadled.tieUp.clear();
  treadled.treadling.clear();
  for (size_t pick = 0; pick < picksOf(draft); ++pick) {
    const std::vector<int> raised = raisedShafts(draft, pick);
    const auto [position, isNew] = treadleOfLift.emplace(raised, static_cast<int>(treadled.tieUp.size()) + 1);
    if (isNew) treadled.tieUp.push_back(draft.risingShed ? raised : otherShafts(raised, draft.shafts));
    treadled.treadling.push_back({position->second});
  }
  treadled.treadles = static_cast<int>(treadled.tieUp.size());
  return treadled;
}

Draft withShed(const Draft& draft, bool rising) {
  if (draft.risingShed == rising) return draft;
  Draft other = draft.liftplan.empty() ? swappable(draft) : withLiftplan(draft);
  if (!other.treadling.empty() && !pressesOneTreadle(other)) other = withTreadles(other);
  if (other.risingShed == rising) return other;
  other.risingShed = rising;
  for (std::vector<int>& tied : other.tieUp) {
    std::sort(tied.begin(), tied.end());
    tied = otherShafts(tied, other.shafts);
  }
  return other;
}

}  // namespace loomlight
