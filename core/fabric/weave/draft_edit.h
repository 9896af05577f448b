#pragma once

#include <span>
#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

// How a draft is edited from both of its sides: in its parts, which changes the weave, and in the weave, which changes
// the parts.

/// The parts of a draft are tables of lines and numbers. Threading: an end and its shafts. Tie-up: a treadle and its
/// shafts. Treadling: a pick and its treadles. Liftplan: a pick and the shafts that go up. Lines count from 0, numbers
/// from 1.
enum class DraftPart { threading, tieUp, treadling, liftplan };

/// Sets or clears one number of a line; the others stay. Line and number as the draft has them (asserted).
Draft withNumber(Draft draft, DraftPart part, int line, int number, bool on);
/// The number in place of all others of its line: an end that changes its shaft.
Draft withOnlyNumber(Draft draft, DraftPart part, int line, int number);
bool hasNumber(const Draft& draft, DraftPart part, int line, int number);
/// All numbers of a line; none of a line that the draft does not have.
std::span<const int> numbersOf(const Draft& draft, DraftPart part, int line);

/// Another number of shafts (or treadles), 0..4096; what used those that are gone is left without.
Draft withShaftCount(Draft draft, int shafts);
Draft withTreadleCount(Draft draft, int treadles);
/// Another repeat, >= 1 both; what fits is kept, new ends and picks continue the old ones. Its drawdown is the old one
/// Weave::resized().
Draft resized(const Draft& draft, int ends, int picks);

/// What the loom has. A weave that takes more shafts is a jacquard; one that takes more treadles has a liftplan.
struct LoomLimits {
  int shafts = 32;
  int treadles = 32;
  friend bool operator==(const LoomLimits&, const LoomLimits&) = default;
};

/// Most crossings of a repeat for which a draft is worked out at every stroke of a brush.
inline constexpr int64_t kMostDerivedCrossings = 4'000'000;

/// The smallest draft of a weave, or why there is none. Shed and liftplan are those of `like`, and shafts and treadles
/// keep the numbers that they have there wherever their ends and picks do.
struct DerivedDraft {
  std::optional<Draft> draft;
  std::string
      remark;  ///< in a weaver's words: why it is none, or why it is a liftplan; empty where nothing is to be said
};
DerivedDraft deriveDraft(const Weave& weave, const LoomLimits& limits, const Draft& like = {});

/// The fabric with another weave. Where it has a draft, that follows, as deriveDraft() says, on a loom that has at
/// least the shafts and treadles of that draft; it is gone where there can be none.
struct Rewoven {
  Fabric fabric;
  std::string remark;
};
Rewoven rewoven(const Fabric& fabric, Weave weave, const LoomLimits& limits);

/// The fabric with another draft, and its weave.
Fabric withDraft(const Fabric& fabric, Draft draft);

}  // namespace loomlight
