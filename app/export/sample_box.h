#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/film/pixel_rect.h"

namespace loomlight {

/// Some samples of a picture: of all pixels of a window, those whose numbers follow one another. On every axis (x, y,
/// sample number) from `low` up to but without `high`.
struct SampleBox {
  glm::ivec3 low{0}, high{0};

  static SampleBox of(const PixelRect& window, int firstSample, int samples);
  PixelRect window() const { return {low.x, low.y, high.x - low.x, high.y - low.y}; }
  bool operator==(const SampleBox&) const = default;
};

/// "samples 64 to 127 of the pixels 0,0,640x480", counted from 0.
std::string inWords(const SampleBox& box);

/// Two that have samples in common, by their places in the list; none where no two have.
std::optional<std::pair<size_t, size_t>> findOverlap(std::span<const SampleBox> boxes);

/// What of a picture is in none of these boxes, no two of which overlap.
std::vector<SampleBox> missingFrom(const SampleBox& picture, std::vector<SampleBox> boxes);

/// The same samples in as few boxes as joining whole sides gives; no two overlap.
std::vector<SampleBox> joined(std::vector<SampleBox> boxes);

/// The smallest window with all of them in it; of at least one.
PixelRect windowAround(std::span<const SampleBox> boxes);

}  // namespace loomlight
