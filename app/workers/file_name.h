#pragma once

#include <string>

namespace loomlight {

/// What kind of file a name stands for: ".json" of "a/b.JSON"; empty where there is no extension.
std::string lowerExtension(const std::string& file);

}  // namespace loomlight
