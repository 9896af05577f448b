#include "render/display/booth.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace loomlight {
namespace {

static_assert(kBoothLamps.size() == 4, "a picture is divided into quarters");

using Sums = PathRecords::Sums;

/// Light of a pixel and of those around it on the same yarn, summed as `lightOf` says, within the window that the sums
/// are of.
template <class LightOf>
Rgb around(const Film& film, const PixelRect& window, int x, int y, const LightOf& lightOf) {
  const int yarn = film.hit(x, y).yarn;
  Rgb sum(0.0f);
  for (int v = std::max(window.y, y - 1); v <= std::min(window.y + window.height - 1, y + 1); ++v)
    for (int u = std::max(window.x, x - 1); u <= std::min(window.x + window.width - 1, x + 1); ++u)
      if (film.hit(u, v).yarn == yarn) sum += lightOf(pixelIndex(u - window.x, v - window.y, window.width));
  return sum;
}

size_t indexIn(const Frame& frame, const BoothPixel& from) {
  return pixelIndex(from.x, from.y, frame.width);
}

}  // namespace

PixelRect boothPiece(int width, int height) {
  const int wide = (width + 1) / 2, high = (height + 1) / 2;
  return {(width - wide) / 2, (height - high) / 2, wide, high};
}

BoothPixel boothPixel(int x, int y, int width, int height) {
  const PixelRect piece = boothPiece(width, height);
  const bool right = x >= piece.width, low = y >= piece.height;
  return {(low ? size_t{2} : size_t{0}) + (right ? size_t{1} : size_t{0}), piece.x + x - (right ? piece.width : 0),
          piece.y + y - (low ? piece.height : 0)};
}

const LampChanges& BoothChanges::at(int x, int y, int ofWidth, int ofHeight) const {
  const PixelRect piece = boothPiece(width, height);
  const auto along = [](int place, int of, int known, int first, int count) {
    return std::clamp(static_cast<int>((2 * int64_t{place} + 1) * known / (2 * int64_t{of})) - first, 0, count - 1);
  };
  const int column = along(x, ofWidth, width, piece.x, piece.width);
  const int row = along(y, ofHeight, height, piece.y, piece.height);
  return pixels[pixelIndex(column, row, piece.width)];
}

BoothChanges boothChanges(const Film& film, const PathRecords& records, const Recolouring* shown,
                          std::span<const Recolouring, kBoothLamps.size()> lamps, int threads) {
  const PixelRect piece = boothPiece(film.width(), film.height());
  BoothChanges changes{film.width(), film.height(), {}};
  changes.pixels.resize(pixelCount(piece.width, piece.height));
  std::vector<Sums> asShown;
  if (shown) asShown = records.recoloured(*shown, piece, threads);
  for (size_t lamp = 0; lamp < lamps.size(); ++lamp) {
    const std::vector<Sums> under = records.recoloured(lamps[lamp], piece, threads);
    parallelFor(static_cast<size_t>(piece.height), threads, [&](size_t row) {
      for (int column = 0; column < piece.width; ++column) {
        const int x = piece.x + column, y = piece.y + static_cast<int>(row);
        const Rgb to = around(film, piece, x, y, [&](size_t i) { return under[i].recoloured; });
        const Rgb from =
            around(film, piece, x, y, [&](size_t i) { return shown ? asShown[i].recoloured : under[i].traced; });
        changes.pixels[pixelIndex(column, static_cast<int>(row), piece.width)][lamp] =
            changeOfLight(from, to, Rgb(1.0f));
      }
    });
  }
  return changes;
}

std::vector<glm::vec4> boothPicture(const Frame& frame, const BoothChanges& changes) {
  const std::span<const glm::vec4> whole = frame.whole();
  std::vector<glm::vec4> picture;
  picture.reserve(whole.size());
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const BoothPixel from = boothPixel(x, y, frame.width, frame.height);
      const LightChange& change = changes.at(from.x, from.y, frame.width, frame.height)[from.lamp];
      picture.push_back(change(whole[indexIn(frame, from)]));
    }
  return picture;
}

std::vector<Film::Hit> boothHits(const Frame& frame) {
  std::vector<Film::Hit> hits;
  hits.reserve(frame.hits.size());
  for (int y = 0; y < frame.height && !frame.hits.empty(); ++y)
    for (int x = 0; x < frame.width; ++x)
      hits.push_back(frame.hits[indexIn(frame, boothPixel(x, y, frame.width, frame.height))]);
  return hits;
}

}  // namespace loomlight
