#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "render/film/image.h"
#include "render/film/pixel_rect.h"
#include "render/film/zero_allocator.h"

namespace loomlight {

/// What one path brings back to its pixel.
struct PathSample {
  Rgb direct{0};    ///< one scattering event
  Rgb indirect{0};  ///< two and more
  float alpha = 0;  ///< 1 where the camera ray met a fibre, else 0
  // Of the first event; only where alpha is 1:
  float depth_mm = 0;
  glm::vec3 normal{0};   ///< of the cloth's face; of the fibre's surface where fibres are explicit
  glm::vec3 tangent{0};  ///< of the fibre
  int yarn = -1;         ///< index into Fabric::yarns
  int end = -1, pick = -1;
  uint32_t events = 0;
};

/// Sums of path samples. The sums are integers (fixed point), so they do not depend on the order of the samples, on
/// threads, tiles, or how samples are split over runs: the same samples give the same bytes. One thread may add to a
/// pixel at a time.
///
/// | sum                    | quantum    | a sample is clamped to |
/// |------------------------|------------|------------------------|
/// | radiance, each channel | 2^-24      | -2^18 .. 2^18          |
/// | luminance squared      | 2^-28      | 0 .. 2^34              |
/// | depth                  | 2^-16 mm   | 0 .. 2^20 mm           |
/// | normal, tangent        | 2^-10      | -1 .. 1                |
///
/// With at most maxSamples samples a pixel no sum can overflow but that of the squares, which saturates at 2^36: the
/// variance is infinite then. NaN counts as 0.
class Film {
 public:
  static constexpr uint32_t maxSamples = 1u << 20;  ///< per pixel; sample indices are below it
  static constexpr size_t bytesPerPixel = 128;      ///< 472 MB for 2560 x 1440

  /// 1..16384 pixels a side. Throws InputError when the machine has less memory than the sums need.
  Film(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  PixelRect window() const { return {0, 0, width_, height_}; }  ///< all of it

  void add(int x, int y, uint32_t sampleIndex, const PathSample& sample);
  /// The sums of another film, whose samples are others than ours and whose top left is our pixel x, y; all of it lies
  /// in ours. Throws InputError when together they are more than maxSamples; this film is then unchanged.
  void merge(const Film& other, int x = 0, int y = 0);
  /// The pixels of a window of it.
  Film cropped(const PixelRect& window) const;

  // Of a pixel; all zero where it has no samples yet, as after a stopped pass.
  uint32_t samples(int x, int y) const { return at(x, y).samples; }
  /// That every pixel of a window has at least; maxSamples where it has no pixel.
  uint32_t fewestSamples(const PixelRect& window) const;
  Rgb mean(int x, int y) const;
  float alpha(int x, int y) const;
  /// Of the luminance of the mean, estimated from the spread of the samples; 0 with fewer than two.
  float variance(int x, int y) const;
  /// Mean over the samples with alpha 1; 0 where there are none.
  float meanDepth_mm(int x, int y) const;
  struct Hit {
    int yarn = -1, end = -1, pick = -1;
    float depth_mm = 0;
  };
  /// Of the lowest-numbered sample that met a fibre. Indices beyond 2^24 are kept as 2^24.
  Hit hit(int x, int y) const;

  /// Linear mean radiance and alpha, premultiplied as alpha already is in the mean: width * height, row by row from the
  /// top left. Reuses the memory of `rgba`. `threads`: 0 for all.
  void toDisplayBuffer(std::vector<glm::vec4>& rgba, int threads = 0) const;

  /// R, G, B, A, direct.*, indirect.*, depth.Z, normal.*, tangent.*, yarn.id, crossing.end, crossing.pick, variance.Y.
  /// Depth, normal and tangent are means over the samples with alpha 1; yarn and crossing are those of hit().
  /// With sums, further channels hold the sums exactly, so that a file can be resumed bit for bit.
  Image toImage(bool withSums) const;
  /// Throws InputError when the image holds no sums.
  static Film fromImage(const Image& image, const std::string& file);

 private:
  /// All zero is a pixel without samples.
  struct alignas(64) Pixel {
    int64_t direct[3], indirect[3];
    uint64_t luminance2;
    uint64_t depth;
    uint64_t events;
    int32_t normal[3], tangent[3];
    uint32_t samples;
    uint32_t hits;        ///< samples with alpha 1
    uint32_t firstIndex;  ///< number of the sample that the following are of; only where hits > 0
    int32_t yarn, end, pick;
    float hitDepth;
  };
  static_assert(sizeof(Pixel) == bytesPerPixel);

  Pixel& at(int x, int y) { return pixels_[pixelIndex(x, y, width_)]; }
  const Pixel& at(int x, int y) const { return const_cast<Film*>(this)->at(x, y); }
  static glm::dvec3 radiance(const Pixel& pixel);
  static Rgb mean(const Pixel& pixel);
  static float variance(const Pixel& pixel);
  static Hit hit(const Pixel& pixel);
  static float meanDepth_mm(const Pixel& pixel);
  template <class P, class Visit>
  static void visitSums(P& pixel, Visit&& visit);

  int width_, height_;
  std::vector<Pixel, ZeroAllocator<Pixel>> pixels_;
};

}  // namespace loomlight
