#pragma once

#include <optional>
#include <vector>

#include "core/fabric/weave.h"

namespace loomlight {

/// A crossing of a weave's repeat.
struct WeavePlace {
  int pick = 0, end = 0;
  bool operator==(const WeavePlace&) const = default;
};

/// Where two weaves of one size differ; nothing where their sizes differ, or where they do in more than `limit` places.
/// Rows that they share cost one comparison of pointers.
std::optional<std::vector<WeavePlace>> weaveChanges(const Weave& before, const Weave& after, size_t limit);

}  // namespace loomlight
