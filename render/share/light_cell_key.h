#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "render/media/medium.h"
#include "render/scene/scene.h"

namespace loomlight {

/// How many levels of cells there are: one of all light, and each dividing the cells of the one before.
inline constexpr int kLightCellLevels = 5;

/// The cells that a place is in, one of each level, coarse first. The level is in the last bits of a key.
struct LightCellPath {
  std::array<uint64_t, kLightCellLevels> keys{};
  uint64_t finest() const { return keys.back(); }
};
inline constexpr uint64_t kLightCellLevelMask = 7;
inline constexpr size_t kLieLevel = 2;  ///< the one from which on cells are of cloth that lies alike

/// Whether every place of a volume is in the same cells for both fabrics, whatever their light and dyes.
bool sameLightCells(const Fabric& before, const Fabric& after);

/// Which places of a cloth look alike, as far as one can tell without light: what a cell is. Repeats of the weave lie
/// in the same cells wherever the same light falls on them in the same way.
///
/// Places in one cell agree in:
/// - level 0: nothing
/// - level 1: warp or weft, yarn, material, how deeply the thread is dyed, whether the face or the back is seen
/// - level 2: the cut edges that are near; how the cloth lies in the world, in steps of some 14 degrees, and which way
///   its ends run; under the headlight, where it lies, in patches of 4 mm
/// - level 3: which side the yarns cross on here and around (3 x 3), which yarns they are and how they are displaced,
///   block of 4 x 4 x 4 voxels
/// - level 4: voxel
///
/// What shade a place is in is not known to its cells, but seen in the film (block_gains.h).
///
/// One thread, as many places as it likes. The scene must outlive it.
class LightCellKeys {
 public:
  explicit LightCellKeys(const Scene& scene);

  /// The cells of the place where a path met its first fibre. `jitter`: two numbers from -1/2 to 1/2, in the steps of
  /// level 2: places near a border of two such steps are then in either.
  LightCellPath of(const Collision& first, glm::vec2 jitter = glm::vec2(0));

 private:
  uint64_t crossingsAround(int pick, int end) const;
  uint64_t edges(int pick, int end) const;

  const TraceData& cloth_;
  const ClothGeometry& geometry_;
  bool lightIsNear_;
  bool isSpaced_ = false;     ///< threads are displaced
  int pick_ = -1, end_ = -1;  ///< whose crossings were looked at last
  uint64_t around_ = 0;
};

}  // namespace loomlight
