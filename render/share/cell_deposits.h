#pragma once

#include <vector>

#include "render/share/first_hits.h"
#include "render/transport/path_tracer.h"

namespace loomlight {

/// Brings the light of a picture's paths to the cells of their first fibres, after every pass; and these cells to the
/// pixels that show them.
class CellDeposits final : public FirstFibreSink {
 public:
  /// All must outlive it.
  CellDeposits(const Scene& scene, CellSums& cells, FirstHits& hits) : scene_(scene), cells_(cells), hits_(hits) {}

  /// Whether the next pass is one at full resolution, whose pixels are those of the hits.
  void ofPixels(bool are) { ofPixels_ = are; }

  void begin(size_t tiles) override;
  void sample(size_t tile, int x, int y, const Ray& ray, const Collision* first, const PathSample& sample) override;
  /// After the pass: adds up what has come, tile by tile.
  void settle();

 private:
  struct Deposit {
    uint32_t pixel;
    uint32_t cell;  ///< FirstHits::kNew: the next of the tile's new paths
    Rgb colour;
  };
  struct Tile {
    explicit Tile(const Scene& scene) : keys(scene) {}
    LightCellKeys keys;
    std::vector<Deposit> deposits;
    std::vector<LightCellPath> fresh;
  };

  const Scene& scene_;
  CellSums& cells_;
  FirstHits& hits_;
  bool ofPixels_ = false;
  std::vector<Tile> tiles_;
};

}  // namespace loomlight
