#pragma once

#include "render/media/medium.h"

namespace loomlight {

/// Which material light has met: that of the yarn, or of a blend (melange) one of its two. The fibres of a blend are
/// mixed evenly, so a volume needs no voxels of its own for it: every fibre that is met is of the second kind with the
/// share that its kind has. Explicit fibres keep what they are: their number decides.
inline int materialMet(const Collision& at, Random& random) {
  if (at.optics.blendShare <= 0) return at.optics.material;
  const float chosen = at.fibre != 0 ? Random(mixBits(at.fibre)).uniform() : random.uniform();
  return chosen < at.optics.blendShare ? at.optics.blendMaterial : at.optics.material;
}

}  // namespace loomlight
