#pragma once

#include <optional>
#include <vector>

#include "app/export/tile.h"

namespace loomlight {

/// What one side of a tile looks like, pixel by pixel: row by row from the top left.
struct SideMaps {
  TileMaps tile;                 ///< its base colour: all that is sent back, of light from this side and through it
  std::vector<Rgb> reflected;    ///< linear; the share of white light from this side's half of the sky that comes back
  std::vector<Rgb> transmitted;  ///< the share of that from the other half that comes through yarn; holes left out
  /// Along the fibres that are seen, in the picture's plane: an axis, of which the end with x >= 0 stands here. Its
  /// length is 1 where all of them lie so, 0 where they lie every way.
  std::vector<glm::vec2> along;
};

/// Both sides of a tile, out of the same volume.
struct TileSides {
  SideMaps front, back;

  const SideMaps& of(ClothSide side) const { return side == ClothSide::front ? front : back; }
};

/// Traces a tile under the light of either half of the sky, from either side: four pictures of the fabric's samples.
/// `longestSide`: pixels. Nothing when stopped. Throws InputError.
std::optional<TileSides> tileSides(const Fabric& fabric, const TileExtent& extent, int longestSide, double limit_bytes,
                                   const Task& task);

}  // namespace loomlight
