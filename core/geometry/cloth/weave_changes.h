#pragma once

#include <optional>
#include <vector>

#include "core/fabric/model/weave.h"

namespace loomlight {

/// A crossing of a weave's repeat.
struct WeaveCrossing {
  int pick = 0, end = 0;
  bool operator==(const WeaveCrossing&) const = default;
};

/// Where two weaves differ, in the ends and picks that both have; nothing where they do in more than `limit` places.
/// In the order of picks, and of ends in each. Rows that they share cost one comparison of pointers.
std::optional<std::vector<WeaveCrossing>> weaveChanges(const Weave& before, const Weave& after, size_t limit);

}  // namespace loomlight
