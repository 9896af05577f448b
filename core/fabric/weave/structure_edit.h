#pragma once

#include <optional>

#include "core/fabric/weave/draft_edit.h"
#include "core/fabric/weave/structure_library.h"
#include "core/fabric/weave/weave_edit.h"

namespace loomlight {

/// A fabric of a single yarn gets another of its kind beside it, dark beside a light one and light beside a dark one;
/// others stay as they are.
Fabric withSecondYarn(Fabric fabric);

/// The fabric with the structure in the selection, or in place of its weave where nothing is selected.
Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const Weave& structure,
                      const LoomLimits& limits);
/// The same; then the first and the second yarn, which there is from then on, follow each other as a colour effect
/// asks.
Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const MadeStructure& structure,
                      const LoomLimits& limits);

}  // namespace loomlight
