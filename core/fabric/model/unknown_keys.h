#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

namespace loomlight {

/// What a file said beside the keys this version knows; written back unchanged. Null where there was nothing. It is no
/// part of the value that holds it: == does not look at it.
using UnknownKeys = std::shared_ptr<const nlohmann::json>;

}  // namespace loomlight
