#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/film/pixel_rect.h"
#include "render/transport/light_columns.h"
#include "render/transport/path_sink.h"

namespace loomlight {

/// All light that one path has met, uncoloured.
class PathLog final : public PathSink {
 public:
  void clear();
  void gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t events) override;

  size_t size() const { return lights_.size(); }
  const PathLight& light(size_t i) const { return lights_[i]; }
  std::span<const float> lengths_mm(size_t i) const {
    const size_t materials = lengths_mm_.size() / lights_.size();
    return std::span(lengths_mm_).subspan(i * materials, materials);
  }

 private:
  std::vector<PathLight> lights_;
  std::vector<float> lengths_mm_;  ///< light after light
};

/// What the colours of a picture come from: fibres and lamps, and how brightly these shine beside what they shone with
/// when the picture was traced, primary by primary.
struct Recolouring {
  Colouring colouring;
  Rgb light{1};
};

/// The first samples of every pixel of a picture, uncoloured: how they look in any colours is a matter of exponentials,
/// not of tracing. Memory is bounded: what is more than that is not kept, of all pixels alike, so that which samples
/// are kept says nothing of what they are. Kept tile by tile; one thread may add to a tile at a time.
class PathRecords {
 public:
  static constexpr int kTile = 16;  ///< pixels a side

  /// For a picture of this size, whose scene has so many materials.
  PathRecords(int width, int height, int materials, size_t bytes);

  int width() const { return width_; }
  int height() const { return height_; }
  uint32_t samples(int x, int y) const { return tileOf(x, y).kept[inTile(x, y)]; }
  size_t bytes() const { return budget_.taken(); }

  /// Whether sample `index` of the pixel is the next to be kept.
  bool takes(int x, int y, uint32_t index) const;
  /// The next sample: its colour when it was traced, and its light.
  void add(int x, int y, Rgb colour, const PathLog& log);
  /// Call it between passes: once there is no room for more, every pixel keeps as many samples as that with the fewest.
  void settle();

  /// Over the kept samples of a pixel, per channel.
  struct Sums {
    Rgb traced{0}, recoloured{0};                                       ///< as they were traced, and in other colours
    Rgb tracedTraced{0}, tracedRecoloured{0}, recolouredRecoloured{0};  ///< of products, about the means
    uint32_t samples = 0;
  };
  /// Of all pixels, row by row from the top left.
  std::vector<Sums> recoloured(const Recolouring& recolouring, int threads) const {
    return recoloured(recolouring, {0, 0, width_, height_}, threads);
  }
  /// Of those in a window.
  std::vector<Sums> recoloured(const Recolouring& recolouring, const PixelRect& window, int threads) const;

 private:
  struct Sample {
    Rgb traced;      ///< its colour when it was traced
    uint32_t pixel;  ///< of the tile
  };
  struct Tile {
    std::vector<Sample> samples;
    std::vector<LightColumns> lights;            ///< that they have met; the kinds ascend
    std::array<uint32_t, kTile * kTile> kept{};  ///< samples of each pixel
  };
  Tile& tileOf(int x, int y) { return tiles_[static_cast<size_t>(y / kTile) * columns_ + x / kTile]; }
  const Tile& tileOf(int x, int y) const { return const_cast<PathRecords*>(this)->tileOf(x, y); }
  static uint32_t inTile(int x, int y) { return static_cast<uint32_t>(y % kTile * kTile + x % kTile); }
  bool addLights(Tile& tile, const PathLog& log);
  void cut(Tile& tile, uint32_t samples);
  static std::array<Sums, kTile * kTile> sum(const Tile& tile, const Recolouring& recolouring);

  int width_, height_;
  size_t materials_, columns_;
  RecordBudget budget_;
  std::vector<Tile> tiles_;
  bool settled_ = false;
};

}  // namespace loomlight
