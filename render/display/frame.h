#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/display/preview_quality.h"
#include "render/film/film.h"
#include "render/film/pixel_rect.h"

namespace loomlight {

/// A picture of the viewport, or of a window onto it; immutable once it is shown. Coarse first passes have fewer,
/// larger pixels, the last of which may reach beyond the window: show as much of them as is within. A picture under way
/// may be fine where it has come to, and as before elsewhere.
struct Frame {
  int width = 0, height = 0;
  std::vector<glm::vec4> rgba;  ///< as traced: linear, premultiplied by alpha; row by row from the top left
  /// For the display alone: with less noise as long as it is young, or in light that repeats share; empty: as rgba.
  std::vector<glm::vec4> helped;
  std::vector<glm::vec4> denoised;  ///< for the display alone: with less noise; empty where not asked for
  std::vector<glm::vec4> booth;     ///< for the display alone: divided (booth.h); empty where not asked for, or unknown
  std::vector<Film::Hit> hits;      ///< yarn and crossing per pixel; -1 where there is no cloth. Empty in the inset
  std::vector<float> variances;     ///< of the luminance; empty where unknown, or where no noise was taken
  PixelRect window;                 ///< what it covers of the viewport
  uint64_t generation = 0;          ///< of the request it answers
  /// Of every pixel at least, with what is left of those of a picture that stood in for it; 0 for a coarse pass.
  int samples = 0;
  int divider = 1;     ///< of the resolution
  double seconds = 0;  ///< since this picture was begun
  PreviewQuality quality = PreviewQuality::clear;
  bool shared = false;  ///< `helped` is light that repeats share

  /// What the display shows where nothing is asked for.
  std::span<const glm::vec4> plain() const { return helped.empty() ? rgba : helped; }
  /// The view as it is shown where it is not divided.
  std::span<const glm::vec4> whole() const { return denoised.empty() ? plain() : denoised; }
  std::span<const glm::vec4> shown() const { return isDivided() ? booth : whole(); }
  bool isDivided() const { return !booth.empty(); }
  /// What its pixels cover: the window, and of a coarse one what the last of them reach beyond it.
  PixelRect reach() const { return {window.x, window.y, divider * width, divider * height}; }
};

}  // namespace loomlight
