#pragma once

#include <vector>

#include "render/film/pixel_rect.h"

namespace loomlight {

/// A window that is traced in square buckets, from the middle outwards: that is where one looks.
class PictureBuckets {
 public:
  /// `side`: of a bucket, pixels; those at the right and the bottom may be smaller. A side of 0: all in one.
  PictureBuckets(const PixelRect& window, int side);

  bool finished() const { return done_ == order_.size(); }
  PixelRect next() const { return bucket(order_[done_]); }
  void finishNext() { isDone_[order_[done_++]] = true; }

  /// How much of a pixel of the window may be seen of what is done: 0 where nothing is, and rising to 1 within a bucket
  /// from its borders with others that are still to be done, so that none of these borders is a line.
  float shown(int x, int y) const;

 private:
  PixelRect bucket(size_t index) const;

  PixelRect window_;
  int width_, height_, columns_, rows_;
  std::vector<size_t> order_;
  std::vector<bool> isDone_;
  size_t done_ = 0;
};

}  // namespace loomlight
