#pragma once

#include <memory>
#include <string>

namespace loomlight {

/// What a file said beside the keys this version knows, as the text of a JSON object; written back unchanged. Null
/// where there was nothing. It is no part of the value that holds it: == does not look at it.
using UnknownKeys = std::shared_ptr<const std::string>;

}  // namespace loomlight
