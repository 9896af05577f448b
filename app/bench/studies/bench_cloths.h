#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A cloth of the report, after ours: its file's name without the ending, for names of pictures.
struct BenchCloth {
  std::string name;
  Fabric fabric;
};

/// The four of Figs. 9 to 14: blue, colourful, black and white, green.
std::vector<BenchCloth> cylinderCloths();
/// The three of Fig. 1: a carpet, a blanket, a curtain.
std::vector<BenchCloth> largeCloths();

/// The fabric on a smaller piece of the same drape, so that it has about that many fibre segments; larger where it has
/// fewer.
Fabric withSegments(Fabric fabric, double segments);
/// The same yarns with another arrangement of their fibres in every crossing: the piece, a repeat longer on every side,
/// so that what lay in the middle is a repeat further on along the cloth; the camera looks at the same place of it. A
/// flat piece or a cylinder.
Fabric rearranged(Fabric fabric);
/// Fibre segments of the whole piece, from its geometry alone.
double segmentsOf(const Fabric& fabric);

}  // namespace loomlight
