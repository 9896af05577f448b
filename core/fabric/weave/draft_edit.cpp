#include "core/fabric/weave/draft_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>

#include "core/fabric/weave/draft_derivation.h"

// How it works. Edits make a new draft of an old one. When the cloth is edited and the draft follows it, the
// smallest draft is derived anew (draft_derivation), whose shafts and treadles are numbered in any order. They get
// the numbers that the loom had: each end votes for the pair of its new shaft and its old one, the pairs take their
// numbers in the order of their votes, and those without a vote take what is left. Treadles likewise, by picks.
// Cost: linear in the draft, beside the derivation; sorting the pairs.

namespace loomlight {
namespace {

NumberLists& linesOf(Draft& draft, DraftPart part) {
  switch (part) {
    case DraftPart::threading:
      return draft.threading;
    case DraftPart::tieUp:
      // Treadles that nothing is tied to may have no line.
      draft.tieUp.resize(static_cast<size_t>(draft.treadles));
      return draft.tieUp;
    case DraftPart::treadling:
      return draft.treadling;
    case DraftPart::liftplan:
      break;
  }
  return draft.liftplan;
}

const NumberLists& linesOf(const Draft& draft, DraftPart part) {
  switch (part) {
    case DraftPart::threading:
      return draft.threading;
    case DraftPart::tieUp:
      return draft.tieUp;
    case DraftPart::treadling:
      return draft.treadling;
    case DraftPart::liftplan:
      break;
  }
  return draft.liftplan;
}

void dropBeyond(NumberLists& lines, int most) {
  for (std::vector<int>& line : lines)
    line.erase(std::remove_if(line.begin(), line.end(), [most](int number) { return number > most; }), line.end());
}

NumberLists continued(const NumberLists& lines, int size) {
  NumberLists longer;
  longer.reserve(static_cast<size_t>(size));
  for (size_t i = 0; i < static_cast<size_t>(size); ++i) longer.push_back(lines[i % lines.size()]);
  return longer;
}

/// For each number 1..count used one a line in `lines`, the number that most of its lines have in `like`, each at most
/// once; what has none keeps the order in which it comes. Entry 0 stands for none.
std::vector<int> numbersAs(const NumberLists& lines, int count, const NumberLists& like) {
  std::map<std::pair<int, int>, int> votes;  // (ours, theirs)
  for (size_t i = 0; i < std::min(lines.size(), like.size()); ++i)
    if (!lines[i].empty() && like[i].size() == 1 && like[i][0] >= 1 && like[i][0] <= count)
      ++votes[{lines[i][0], like[i][0]}];
  std::vector<std::pair<std::pair<int, int>, int>> ranked(votes.begin(), votes.end());
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.second > b.second; });

  std::vector<int> numberOf(static_cast<size_t>(count) + 1, 0);
  std::vector<bool> taken(static_cast<size_t>(count) + 1, false);
  for (const auto& [pair, weight] : ranked) {
    if (numberOf[pair.first] != 0 || taken[pair.second]) continue;
    numberOf[pair.first] = pair.second;
    taken[pair.second] = true;
  }
  int next = 1;
  for (int number = 1; number <= count; ++number) {
    if (numberOf[number] != 0) continue;
    while (taken[next]) ++next;
    numberOf[number] = next;
    taken[next] = true;
  }
  return numberOf;
}

void renumber(NumberLists& lines, const std::vector<int>& numberOf) {
  for (std::vector<int>& line : lines) {
    for (int& number : line) number = numberOf[number];
    std::sort(line.begin(), line.end());
  }
}

/// A smallest draft with the numbers that `like` has for the same ends and picks.
Draft numberedAs(Draft draft, const Draft& like) {
  const std::vector<int> shaft = numbersAs(draft.threading, draft.shafts, like.threading);
  const std::vector<int> treadle = numbersAs(draft.treadling, draft.treadles, like.treadling);
  renumber(draft.threading, shaft);
  renumber(draft.tieUp, shaft);
  renumber(draft.treadling, treadle);
  NumberLists tieUp(draft.tieUp.size());
  for (size_t i = 0; i < tieUp.size(); ++i) tieUp[treadle[i + 1] - 1] = std::move(draft.tieUp[i]);
  draft.tieUp = std::move(tieUp);
  return draft;
}

}  // namespace

std::span<const int> numbersOf(const Draft& draft, DraftPart part, int line) {
  const NumberLists& lines = linesOf(draft, part);
  if (static_cast<size_t>(line) >= lines.size()) return {};
  return lines[line];
}

bool hasNumber(const Draft& draft, DraftPart part, int line, int number) {
  const std::span<const int> numbers = numbersOf(draft, part, line);
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

Draft withNumber(Draft draft, DraftPart part, int line, int number, bool on) {
  assert(number >= 1 && number <= (part == DraftPart::treadling ? draft.treadles : draft.shafts));
  std::vector<int>& numbers = linesOf(draft, part).at(line);
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), [=](int n) { return n == number || n == 0; }),
                numbers.end());
  if (on) numbers.insert(std::upper_bound(numbers.begin(), numbers.end(), number), number);
  return draft;
}

Draft withOnlyNumber(Draft draft, DraftPart part, int line, int number) {
  linesOf(draft, part).at(line).clear();
  return withNumber(std::move(draft), part, line, number, true);
}

Draft withShaftCount(Draft draft, int shafts) {
  draft.shafts = shafts;
  dropBeyond(draft.threading, shafts);
  dropBeyond(draft.tieUp, shafts);
  dropBeyond(draft.liftplan, shafts);
  return draft;
}

Draft withTreadleCount(Draft draft, int treadles) {
  draft.treadles = treadles;
  draft.tieUp.resize(static_cast<size_t>(treadles));
  dropBeyond(draft.treadling, treadles);
  return draft;
}

Draft resized(const Draft& draft, int ends, int picks) {
  Draft other = draft;
  other.threading = continued(draft.threading, ends);
  if (draft.liftplan.empty())
    other.treadling = continued(draft.treadling, picks);
  else
    other.liftplan = continued(draft.liftplan, picks);
  return other;
}

DerivedDraft deriveDraft(const Weave& weave, const LoomLimits& limits, const Draft& like) {
  if (int64_t{weave.ends()} * weave.picks() > kMostDerivedCrossings)
    return {std::nullopt,
            fmt::format("Too large to be threaded: over {} million crossings.", kMostDerivedCrossings / 1'000'000)};
  std::optional<Draft> draft = smallestDraft(weave, limits.shafts);
  if (!draft) return {std::nullopt, fmt::format("Jacquard: more than {} shafts.", limits.shafts)};
  DerivedDraft derived;
  const bool lifted = !like.liftplan.empty();
  if (!lifted && draft->treadles > limits.treadles)
    derived.remark = fmt::format("Liftplan: {} treadles, more than {}.", draft->treadles, limits.treadles);
  Draft made = withShed(numberedAs(std::move(*draft), like), like.risingShed);
  if (lifted || !derived.remark.empty()) made = withLiftplan(std::move(made));
  made.unknown = like.unknown;
  derived.draft = std::move(made);
  return derived;
}

Rewoven rewoven(const Fabric& fabric, Weave weave, const LoomLimits& limits) {
  Rewoven result{fabric, {}};
  result.fabric.weave = std::move(weave);
  if (!fabric.draft) return result;
  // A draft from elsewhere tells of a larger loom than the one that was set.
  const LoomLimits loom{std::max(limits.shafts, fabric.draft->shafts),
                        std::max(limits.treadles, fabric.draft->treadles)};
  DerivedDraft derived = deriveDraft(result.fabric.weave, loom, *fabric.draft);
  result.fabric.draft = std::move(derived.draft);
  result.remark = std::move(derived.remark);
  return result;
}

Fabric withDraft(const Fabric& fabric, Draft draft) {
  Fabric other = fabric;
  other.weave = drawdown(draft);
  other.draft = std::move(draft);
  return other;
}

}  // namespace loomlight
