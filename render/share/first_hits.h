#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "render/film/pixel_rect.h"
#include "render/media/medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/scene.h"
#include "render/share/cell_sums.h"

namespace loomlight {

/// Which cells each pixel of a picture shows: the first fibres of some paths through it, which end there and so cost a
/// fraction of a path that looks for light. A pure function of (seed, camera, cloth, drape, the medium's law of events,
/// what keys are made of): light and dyes may change, as long as sameLightCells().
class FirstHits {
 public:
  static constexpr uint32_t kMost = 16;  ///< of a pixel, as far as kLimit_bytes goes
  /// That all hits take: large pictures keep fewer of each pixel, but one, so that more than 16 million pixels take
  /// more.
  static constexpr size_t kLimit_bytes = size_t{64} << 20;
  static constexpr uint32_t kPast = ~0u;           ///< past the cloth
  static constexpr uint32_t kThrough = kPast - 1;  ///< through the cloth, between its fibres
  static constexpr uint32_t kNew = kThrough - 1;   ///< a cell that has no number yet

  FirstHits(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  uint32_t perPixel() const { return have_; }  ///< that have been traced for every pixel
  /// Whether every pixel, or at least that of every second row and column, has some. Those of the pixels about it stand
  /// for a pixel as long as it has none.
  bool standForAll() const { return have_ > 0 || hasQuarter_; }
  uint32_t most() const { return most_; }  ///< that a pixel keeps
  /// Traces so many for every pixel in all, and makes their cells; a pixel keeps kMost of them at most. The first
  /// are of a quarter of the pixels. Where there is a budget, `budget_s`, it ends when they are there, and where it
  /// takes longer, after some bands of rows; the next call goes on. False when stopped: then it has those that it had.
  bool trace(uint32_t perPixel, const Scene& scene, const Medium& medium, CellSums& cells, const Task& task,
             double budget_s = std::numeric_limits<double>::infinity());
  /// Another one, of a path that has been traced for its light; forgotten where the pixel has enough.
  void put(size_t pixel, uint32_t cell) {
    if (!isFull(pixel)) cells_[pixel * most_ + counts_[pixel]++] = cell;
  }
  static bool isCell(uint32_t hit) { return hit < kThrough; }
  bool isFull(size_t pixel) const { return counts_[pixel] >= most_; }
  /// Of a ray that met no fibre.
  static uint32_t missed(bool isThrough) { return isThrough ? kThrough : kPast; }
  /// A cell, kPast or kThrough each.
  std::span<const uint32_t> of(int x, int y) const {
    const size_t pixel = pixelAt(x, y);
    return {&cells_[pixel * most_], counts_[pixel]};
  }
  /// What is to be seen there: the pixel's own, or those of the nearest in even rows and columns.
  template <class Visit>
  void forEachSeen(int x, int y, const Visit& visit) const {
    const bool isOwn = counts_[pixelAt(x, y)] > 0;
    const int right = isOwn ? 0 : x % 2, down = isOwn ? 0 : y % 2;
    for (int v = y - down; v <= std::min(y + down, height_ - 1); v += 2)
      for (int u = x - right; u <= std::min(x + right, width_ - 1); u += 2)
        for (const uint32_t hit : of(u, v)) visit(hit);
  }
  size_t pixelAt(int x, int y) const { return pixelIndex(x, y, width_); }

 private:
  /// Those that a pixel has of the rounds; others may be put() to them.
  uint32_t traced(int x, int y) const { return have_ == 0 && hasQuarter_ && x % 2 == 0 && y % 2 == 0 ? 1 : have_; }
  bool traceBand(const Scene& scene, const Medium& medium, CellSums& cells, const Task& task);

  int width_, height_;
  uint32_t most_, have_ = 0;
  uint32_t coming_ = 0;  ///< that every pixel has when the round under way is done
  int nextRow_ = 0;      ///< of that round
  /// Each pixel of every second row and column has its first.
  bool hasQuarter_ = false;
  std::vector<uint32_t, ZeroAllocator<uint32_t>> cells_;
  std::vector<uint8_t> counts_;  ///< that each pixel has
};

}  // namespace loomlight
