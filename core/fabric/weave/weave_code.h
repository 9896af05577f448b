#pragma once

#include <optional>
#include <string>

#include "core/fabric/model/weave.h"

namespace loomlight {

/// The code of ISO 9354 of a basic weave, in four parts: "20-02 01-01-01" is a twill 2/1.
/// - kind: 1 plain weave and its ribs and baskets, 2 twill, 3 satin; then 0: the code begins with an end that is up;
/// - how many picks this end goes over, under, over...
/// - how many ends side by side weave alike; where groups differ, of each group;
/// - by how many picks later the next group does the same; 00 where groups just alternate.
/// Nothing where the standard has no code: for weaves of other kinds, or with a number beyond 99.
std::optional<std::string> isoWeaveCode(const Weave& weave);

}  // namespace loomlight
