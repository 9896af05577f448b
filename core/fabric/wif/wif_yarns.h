#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/wif_document.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/wif/wif_warnings.h"

/// The yarns of a weaving file's threads: what its numbers for thickness and colour become in a fabric.
namespace loomlight {

/// As many digits as figures in such files have.
double tidy(double value);

/// The yarn with `factor` times its mass per length, as far as a yarn can have it; `held` is set where it cannot.
Yarn heavier(Yarn yarn, const Fibre& fibre, double factor, bool& held);
/// What is said where a yarn was held.
WifWarning heldYarns();

/// Gives the fabric, which is a copy of the designer's, a yarn for every colour and thickness of the document's
/// threads: the designer's first of the warp and of the weft, dyed, and perhaps thicker. What does not fit into
/// kMaxKinds yarns becomes the nearest that does, with a warning. Returns what each yarn was given.
std::vector<WifYarn> dressThreads(Fabric& fabric, const WifDocument& document, std::vector<WifWarning>& warnings);

/// The origin of a fabric that has just been given its sizes.
std::shared_ptr<const WifOrigin> withSizesOf(WifOrigin origin, const Fabric& fabric);

}  // namespace loomlight
