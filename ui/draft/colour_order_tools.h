#pragma once

#include <optional>

#include "core/fabric/model/fabric.h"
#include "core/fabric/weave/thread_sequence.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// What the tools for colour orders remember between frames.
struct ColourOrderView {
  bool weft = false;         ///< they work on the weft; else on the warp
  bool stripesOpen = false;  ///< the table of stripes
  StripeChance stripes;
};

/// Ways to make a colour order from the one that is there, or by chance. The fabric after an edit.
std::optional<Fabric> colourOrderTools(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours,
                                       ColourOrderView& view);

}  // namespace loomlight
