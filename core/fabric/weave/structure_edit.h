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
/// Puts a structure with a colour effect into the selection, or in place of the weave, and lets the first and the
/// second yarn follow each other as the effect asks. A fabric of one yarn gets a second one (withSecondYarn).
Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const MadeStructure& structure,
                      const LoomLimits& limits);

}  // namespace loomlight
