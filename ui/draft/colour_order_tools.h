#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/weave/yarn_sequence.h"
#include "ui/draft/stripe_table.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// What the tools for colour orders remember between frames.
struct ColourOrderView {
  bool weft = false;        ///< they work on the weft; else on the warp
  bool stripesOpen = true;  ///< the table of stripes
  bool randomOpen = false;  ///< stripes by chance
  StripeRows warpStripes, weftStripes;
  StripeChance stripes;
};

/// Ways to make a colour order from the one that is there, stripe by stripe or by chance. The fabric after an edit.
std::optional<Fabric> colourOrderTools(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours,
                                       const std::vector<std::string>& yarnNames, ColourOrderView& view);

}  // namespace loomlight
