#pragma once

#include <optional>

#include "core/fabric/model/weave.h"

namespace loomlight {

/// The smallest draft of one shaft an end and one treadle a pick that makes the weave, in a rising shed: ends that
/// always go together hang on one shaft, picks that are alike share a treadle, both numbered as they come first. No
/// draft needs fewer shafts. What a loom has, or a Draft may have (validateDraft), is for the caller to compare: a
/// jacquard has thousands. Costs ends x distinct picks, and keeps the tie-up.
Draft smallestDraft(const Weave& weave);
/// The smallest draft, or nothing where it has more than `mostShafts`; a jacquard is found out after a few picks.
std::optional<Draft> smallestDraft(const Weave& weave, int mostShafts);

// The same cloth by other means. Where ends hang on several shafts, and up and down have to be swapped, the draft is
// made anew: such an end follows whichever of its shafts moves, which has no reverse.

/// Lifts written out pick by pick, in place of tie-up and treadling: for dobby looms.
Draft withLiftplan(Draft draft);
/// A tie-up of the lifts that differ, and one treadle a pick, in place of a liftplan or of several treadles a pick.
Draft withTreadles(const Draft& draft);
/// The other shed: what was raised is left, what was left is pulled down. Treadles are kept where each pick presses
/// one, and made anew where not. A liftplan says what goes up in either shed, and stays alone.
Draft withShed(const Draft& draft, bool rising);

}  // namespace loomlight
