#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/fabric/model/weave.h"

namespace loomlight {

/// A rectangle of crossings of the endless cloth; sizes >= 1.
struct CellRect {
  int pick = 0, end = 0;
  int picks = 1, ends = 1;
  bool contains(int p, int e) const { return p >= pick && p < pick + picks && e >= end && e < end + ends; }
  friend bool operator==(const CellRect&, const CellRect&) = default;
};

/// What lies in the rectangle, which may reach over the edge of the repeat.
Weave partOf(const Weave& weave, const CellRect& rect);
/// The weave with `part` laid on it, its first end and pick at the place given; it goes on over the edge of the repeat,
/// and stops where it would come back to itself.
Weave withPart(const Weave& weave, int pick, int end, const Weave& part);
/// The weave with the rectangle filled by a pattern that repeats, from the rectangle's corner on.
Weave withPattern(const Weave& weave, const CellRect& rect, const Weave& pattern);

/// Ends in reverse order; picks in reverse order.
Weave mirroredEnds(const Weave& weave);
Weave mirroredPicks(const Weave& weave);
/// Turned to the right by a quarter: what were picks are ends.
Weave quarterTurned(const Weave& weave);
/// Warp over for weft over.
Weave inverted(const Weave& weave);
/// Moved by so many ends and picks; what leaves on one side comes back on the other.
Weave shifted(const Weave& weave, int ends, int picks);

/// Point paper as text, '#' for warp over and '.' for weft over, the first pick in the last line.
std::string weaveText(const Weave& weave);
/// Reads it back; nothing where the text is something else, or too large for a weave.
std::optional<Weave> weaveFromText(std::string_view text);

}  // namespace loomlight
