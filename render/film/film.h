#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "render/film/image.h"

namespace loomlight {

/// What one path brings back to its pixel.
struct PathSample {
  Rgb direct{0};         ///< one scattering event
  Rgb indirect{0};       ///< two and more, and light that came through unscattered
  float alpha = 0;       ///< 1 where the camera ray met a fibre
  // Of the first event; only where alpha is 1:
  float depth_mm = 0;
  glm::vec3 normal{0};   ///< of the cloth's face
  glm::vec3 tangent{0};  ///< of the fibre
  int yarn = -1;         ///< index into Fabric::yarns
  int end = -1, pick = -1;
  uint32_t events = 0;
};

/// Sums of path samples. The sums are integers (fixed point), so they do not depend on the order of the samples, on
/// threads, tiles, or how samples are split over runs: the same samples give the same bytes. One thread may add to a
/// pixel at a time.
class Film {
 public:
  Film(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }

  void add(int x, int y, uint32_t sampleIndex, const PathSample& sample);
  /// The sums of another film of the same size, whose samples are others than ours.
  void merge(const Film& other);
  void clear();

  uint32_t samples(int x, int y) const;
  Rgb mean(int x, int y) const;
  float alpha(int x, int y) const;
  float variance(int x, int y) const;   ///< of the luminance of the mean
  struct Hit { int yarn = -1, end = -1, pick = -1; float depth_mm = 0; };
  Hit hit(int x, int y) const;          ///< of the lowest-numbered sample that met a fibre
  double totalEvents() const;

  /// R, G, B, A, direct.*, indirect.*, depth.Z, normal.*, tangent.*, yarn.id, crossing.end, crossing.pick, variance.Y.
  /// With sums, further channels hold the sums exactly, so that a file can be resumed bit for bit.
  Image toImage(bool withSums) const;
  /// Throws InputError when the image holds no sums.
  static Film fromImage(const Image& image, const std::string& file);
};

}  // namespace loomlight
