#pragma once

#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/yarn/cloth_part.h"
#include "render/media/medium.h"
#include "render/scene/scene.h"

namespace loomlight {

/// What a spectrophotometer says of a cloth.
struct Reflectance {
  Spectrum mean{};           ///< 1 is a perfect diffuser
  Spectrum standardError{};  ///< bands err together, since all see the same paths
};

/// Light on its way from an eye straight above the cloth back to a white sky, black below: how a spectrophotometer
/// looks at cloth. Absorption enters a path only as exp(-sum sigma_k L_k), so the lengths L_k that it has gone inside
/// each fibre material are all that its colour depends on: one set of paths answers for every dye.
struct PathLengthTally {
  size_t materials = 0;           ///< of the scene
  size_t count = 0;               ///< paths that met the part in question first
  std::vector<float> lengths_mm;  ///< of those that came out to the sky: path by path, one length for each material

  size_t lit() const { return materials > 0 ? lengths_mm.size() / materials : 0; }
  /// What shows, where that part lies on top, with these absorptions (1/mm, per material). 1 is white paper.
  Rgb colour(const std::vector<Rgb>& absorption_per_mm) const;
  Rgb colour(const Colouring& colouring) const;
  /// The same in each band, whatever the lamps: what a spectrophotometer reads that lights from all of the sky and
  /// looks from straight above, gloss included, with black behind (d/0).
  Reflectance reflectance(const Colouring& colouring) const;
};

/// The fabric on a flat patch for tallyPathLengths: its repeat, as far as that is not too large, and what light travels
/// sideways around it. Its yarns are evenly spun, as it is to stand for all of the cloth. It is never traced by the
/// report's estimator, but by ours.
Fabric colourPatch(Fabric fabric);

/// Whether paths through the patch of one fabric tell the colours of the other's: it is flat, under its own sky.
bool tracedAlike(const Fabric& a, const Fabric& b);

/// `count` paths, and as many more as fill a batch, that first meet a fibre of the part, over the middle of the scene
/// of a colourPatch(); fewer where hardly any does, none where it never lies on top. A function of the scene's seed;
/// paths of different `stream` are independent. nullopt when stopped.
std::optional<PathLengthTally> tallyPathLengths(const Scene& scene, const Medium& medium, const ClothPart& part,
                                                size_t count, const Task& task, uint64_t stream = 0);
/// The same for each yarn of the fabric at once; more paths of yarns that show more than others.
std::optional<std::vector<PathLengthTally>> tallyYarns(const Scene& scene, const Medium& medium, size_t count,
                                                       const Task& task);

}  // namespace loomlight
