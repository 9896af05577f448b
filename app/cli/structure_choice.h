#pragma once

#include <string>

#include "core/fabric/weave/structure_library.h"

namespace loomlight {

/// "satin,8,3": a structure of the library by its name, whatever its letters' case, then its numbers in the library's
/// order; those that are left out are as it starts with. Throws UsageError naming `option`, and what it takes.
MadeStructure parseStructure(const std::string& option, const std::string& text);

}  // namespace loomlight
