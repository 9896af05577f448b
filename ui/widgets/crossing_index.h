#pragma once

#include "core/base/modulo.h"
#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A crossing of the cloth: what the draft and the viewport light up for each other.
struct CrossingIndex {
  int pick = 0, end = 0;
  bool operator==(const CrossingIndex&) const = default;
};

/// Which crossing of the repeat this one repeats.
inline CrossingIndex inRepeat(const CrossingIndex& c, const Weave& weave) {
  return {wrap(c.pick, weave.picks()), wrap(c.end, weave.ends())};
}

}  // namespace loomlight
