#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"
#include "tests/bench/relaxation.h"

namespace loomlight {

/// A construction that the closed-form law is compared with its relaxation on.
struct Construction {
  const char* name;
  bool wasFitted;  ///< one of the eight that the law's constants were read off
  RelaxedCloth cloth;
};
std::vector<Construction> constructions();

/// The same cloth, washed, as the program makes it: even singles that flatten as most do.
Fabric fabricOf(const RelaxedCloth& cloth);

}  // namespace loomlight
