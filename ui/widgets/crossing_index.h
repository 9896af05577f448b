#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A crossing of the cloth: what the draft and the viewport light up for each other.
struct CrossingIndex {
  int pick = 0, end = 0;
  bool operator==(const CrossingIndex&) const = default;
};

/// The remainder that is never negative.
inline int wrapped(int value, int period) {
  const int r = value % period;
  return r < 0 ? r + period : r;
}

/// Which crossing of the repeat this one repeats.
inline CrossingIndex inRepeat(const CrossingIndex& c, const Weave& weave) {
  return {wrapped(c.pick, weave.picks()), wrapped(c.end, weave.ends())};
}

}  // namespace loomlight
