#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/film/pixel_rect.h"
#include "render/share/cell_sums.h"
#include "render/share/openness.h"
#include "render/share/shared_picture.h"

namespace loomlight {

/// What the rays through each pixel of a picture met first, and the picture of cells that this makes. Several
/// threads may report at once, each pixel from one of them.
class SeenFibres {
 public:
  SeenFibres(int width, int height);

  /// A ray met a fibre, from whose cell such light comes: a Mean of zero where nothing is known of it.
  void meets(size_t pixel, const CellMeans::Mean& light);
  /// A ray met none: it went `through` the cloth, between its fibres, or else past the cloth.
  void misses(size_t pixel, bool through);

  /// How open pixels are is known from those around them as well (openness.h), and so are their fibres where all of
  /// their own rays went through.
  SharedPicture picture(int threads) const;

 private:
  size_t indexOf(int x, int y) const { return pixelIndex(x, y, width_); }
  CellMeans::Mean fibresNear(int x, int y) const;

  int width_, height_;
  // Row by row from the top left.
  std::vector<ClothRays> rays_;
  std::vector<uint32_t> past_;           ///< rays past the cloth
  std::vector<CellMeans::Mean> fibres_;  ///< sums over rays that met one
};

}  // namespace loomlight
