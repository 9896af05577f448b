#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/film/film.h"
#include "render/film/image.h"

namespace loomlight {

/// A seamless tile of a cloth for other programs: what their textures hold, rendered by our own tracer.

struct TileExtent {
  int ends = 1, picks = 1;
  /// The twist of every yarn comes round as well, so that each fibre goes on in the next tile. Where that would take
  /// too large a tile, only weave and colours do.
  bool twistJoins = true;

  Tiling tiling() const { return {ends, picks}; }
};
/// The smallest rectangle of crossings that repeats: weave, order of colours, and where `joinTwist` and up to 2000
/// ends or picks a side, twist. Throws InputError where colours alone take more than Weave::kMaxSide.
TileExtent tileExtent(const Fabric& fabric, bool joinTwist = true);

/// Pixels across the finer of its yarns, in a picture of it whose longer side has so many.
double pixelsPerYarn(const Fabric& fabric, const TileExtent& extent, int longestSide);
/// Fewer show no yarn, but a colour for each thread.
inline constexpr double kFewestPixelsPerYarn = 8;
/// A longer side of 16 pixels for each thread, from 1024 to 16384.
int usualTileSide(const Fabric& fabric, const TileExtent& extent);

/// Throws InputError where pictures of a tile take more than `limit_bytes` together, at so many a pixel; it says which
/// side would do.
void expectMemoryFor(const Fabric& fabric, const TileExtent& extent, int longestSide, double bytesPerPixel,
                     double limit_bytes);

/// Of one repeat, as it is drafted: the cloth that is traced for a tile is stretched by a fraction of a pixel, and its
/// yarns are even.
ClothMeasures measuresOf(const Fabric& fabric, const TileExtent& extent, const Task& task);

/// The side of the cloth that a tile shows. The back is what is seen once the cloth is turned over like a page, about
/// the vertical axis of the front's picture: column c of one lies behind column width - 1 - c of the other, rows stay.
enum class ClothSide { front, back };

/// The fabric as it is rendered for a tile, together with its tiling(): of yarns that are even and without slubs, as
/// every one of these would come again in each tile; flat, several tiles wide, in white light from everywhere, seen
/// straight from above its side without perspective; the picture is the tile in the middle. `longestSide`:
/// pixels, 16..16384.
Fabric tileScene(const Fabric& fabric, const TileExtent& extent, int longestSide, ClothSide side = ClothSide::front);

/// The maps, row by row from the top left, the first pick at the bottom; of the front the first end is at the left, of
/// the back at the right.
struct TileMaps {
  int width = 0, height = 0;
  std::vector<Rgb> baseColour;    ///< linear; the share of light from everywhere that yarn sends back, its noise
                                  ///< taken from it within each crossing; in holes that of the nearest yarn
  std::vector<float> opacity;     ///< 0..1: the share of a pixel that yarn covers, seen from above
  std::vector<float> height_mm;   ///< above the cloth's mid-plane, towards the eye; in holes the lowest of the yarns
  std::vector<glm::vec3> normal;  ///< of the height, smoothed over a pixel; x to the right, y up, z towards the eye
  std::vector<int> yarn;          ///< index into Fabric::yarns; -1 in holes
};
/// Of a film of tileScene(). `threads`: 0 for all.
TileMaps tileMaps(const Film& film, const Fabric& scene, int threads);

struct TileReport {
  std::string json;                ///< the sidecar: sizes, mass, thickness, ranges of the maps
  std::vector<std::string> files;  ///< that were written
};
/// Writes STEM.exr (all maps, linear; the opacity is a layer, as an alpha would mean colours that it has darkened),
/// STEM_basecolor.png, _normal.png (y up), _height.png, _opacity.png, _yarn.png and STEM.json, which says what they
/// are. The pictures carry their size as dots per inch. They are put in their places together (FileSet). `names`: of
/// the fabric's yarns. Throws InputError.
TileReport writeTile(const std::string& stem, const TileMaps& maps, const Fabric& fabric, const TileExtent& extent,
                     const ClothMeasures& measures, const std::vector<std::string>& names);

struct TileOrder {
  int longestSide = 0;  ///< pixels; 0: usualTileSide()
  bool joinTwist = true;
};
/// All of it. Nothing when stopped. `limit_bytes`: of explicit fibres, and of the pictures. Throws InputError; where
/// they take more memory, or the file cannot be written, before the long work.
std::optional<TileReport> makeTile(const Fabric& fabric, const std::string& stem, const TileOrder& order,
                                   double limit_bytes, const Task& task);

}  // namespace loomlight
