#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

class FieldPath;

/// Most yarns, and most fibres, of a fabric.
inline constexpr int kMaxKinds = 64;
/// Most threads of a yarn sequence before it repeats.
inline constexpr int kMaxSequence = 16384;
/// Most fibres in the section of one yarn, all plies together. With a count in tex the number follows from the fibre's
/// fineness, so a coarse yarn of very fine fibres could ask for more than any machine holds.
inline constexpr int kMaxFibresInYarn = 20000;
/// Most shaft or treadle numbers in a draft's threading and treadling, and in its tie-up and liftplan: they bound the
/// time of a drawdown.
inline constexpr int kMaxThreadingEntries = 8 * Weave::kMaxSide;
inline constexpr int kMaxLiftEntries = 2'000'000;

/// Throws InputError unless every value is in its range (field_tables.h), every index names something, all sizes are
/// allowed, and the weave is the drawdown of the draft where there is one. `source` says whose fabric it is and starts
/// the message: `source: yarns[1].plies: expected a whole number from 1 to 8, got 9`. Everything behind this
/// (geometry, volume, light) relies on it.
void validate(const Fabric& fabric, const std::string& source);

/// The draft alone: sizes, shafts and treadles. After it drawdown(draft) is safe.
void validateDraft(const Draft& draft, const FieldPath& path);

}  // namespace loomlight
