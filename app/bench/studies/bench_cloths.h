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
/// A fabric of the same yarns, whose fibres lie otherwise in every crossing that is seen. The piece becomes longer by a
/// repeat on every side, so that another repeat of the cloth, with fibres of its own, comes to lie in the middle, where
/// the camera looks. For a flat piece or a cylinder.
Fabric rearranged(Fabric fabric);
/// Fibre segments of the whole piece, from its geometry alone.
double segmentsOf(const Fabric& fabric);

}  // namespace loomlight
