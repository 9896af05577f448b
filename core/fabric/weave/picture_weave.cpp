#include "core/fabric/weave/picture_weave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/fabric/weave/picture_rims.h"

// How it works. A picture with no more colours than are wanted keeps them. Else the colours of its areas are counted in
// bins, without the mixtures on their rims (picture_rims.h), and the palette is found among the bins by k-means with a
// fixed beginning: the commonest bin first, then always the bin that the centres so far stand for worst, weighted by
// how common it is; then Lloyd's iteration. Each pixel gets the nearest colour of the palette, a rim that of the nearer
// area beside it, and each colour's structure is woven where the pixels have it.

namespace loomlight {
namespace {

// Colours are counted in bins of 5 bits a channel, so that the time of a reduction does not hang on the size of the
// picture.
constexpr int kBits = 5;
constexpr size_t kMostColours = 32;
constexpr size_t kBins = size_t{1} << (3 * kBits);

size_t binOf(const Rgb8& c) {
  return static_cast<size_t>(c[0] >> (8 - kBits)) << (2 * kBits) | static_cast<size_t>(c[1] >> (8 - kBits)) << kBits |
         static_cast<size_t>(c[2] >> (8 - kBits));
}

using Bin = ColourCounts::Bin;
double lightness(const Rgb8& c) {
  return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
}

std::vector<Bin> binsOf(const Raster& raster) {
  struct Sum {
    double n = 0, r = 0, g = 0, b = 0;
  };
  const std::vector<PixelKind> kinds = pixelKinds(raster);
  const bool hasAreas = std::find(kinds.begin(), kinds.end(), PixelKind::area) != kinds.end();
  std::vector<Sum> sums(kBins);
  for (size_t i = 0; i < kinds.size(); ++i) {
    if (hasAreas && kinds[i] != PixelKind::area) continue;
    const Rgb8& c = raster.pixels[i];
    Sum& sum = sums[binOf(c)];
    sum.n += 1, sum.r += c[0], sum.g += c[1], sum.b += c[2];
  }
  std::vector<Bin> bins;
  for (const Sum& sum : sums)
    if (sum.n > 0) bins.push_back({sum.n, {sum.r / sum.n, sum.g / sum.n, sum.b / sum.n}});
  return bins;
}

/// Where to begin: the commonest colour, then always the one that the others stand for worst.
std::vector<ExactColour> firstCentres(const std::vector<Bin>& bins, size_t count) {
  std::vector<double> worst(bins.size(), std::numeric_limits<double>::max());
  size_t next = 0;
  for (size_t i = 1; i < bins.size(); ++i)
    if (bins[i].weight > bins[next].weight) next = i;
  std::vector<ExactColour> centres;
  while (centres.size() < count) {
    centres.push_back(bins[next].mean);
    double most = -1;
    for (size_t i = 0; i < bins.size(); ++i) {
      worst[i] = std::min(worst[i], distance2(bins[i].mean, centres.back()));
      if (worst[i] * bins[i].weight > most) most = worst[i] * bins[i].weight, next = i;
    }
  }
  return centres;
}

size_t nearest(const std::vector<ExactColour>& centres, const ExactColour& colour) {
  size_t best = 0;
  for (size_t i = 1; i < centres.size(); ++i)
    if (distance2(centres[i], colour) < distance2(centres[best], colour)) best = i;
  return best;
}

/// Lloyd's iteration: every centre moves to the mean of the bins that are nearest to it.
std::vector<ExactColour> settled(std::vector<ExactColour> centres, const std::vector<Bin>& bins) {
  constexpr int kRounds = 24;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<ExactColour> sums(centres.size(), ExactColour{});
    std::vector<double> weights(centres.size(), 0);
    for (const Bin& bin : bins) {
      const size_t c = nearest(centres, bin.mean);
      weights[c] += bin.weight;
      for (size_t k = 0; k < 3; ++k) sums[c][k] += bin.weight * bin.mean[k];
    }
    for (size_t c = 0; c < centres.size(); ++c)
      for (size_t k = 0; k < 3 && weights[c] > 0; ++k) centres[c][k] = sums[c][k] / weights[c];
  }
  return centres;
}

Rgb8 rounded(const ExactColour& c) {
  const auto whole = [](double value) { return static_cast<uint8_t>(std::lround(value)); };
  return {whole(c[0]), whole(c[1]), whole(c[2])};
}

/// The distinct colours, where they are at most `most`; else empty.
std::vector<Rgb8> fewColours(const Raster& raster, size_t most) {
  std::vector<Rgb8> found;
  for (const Rgb8& c : raster.pixels) {
    if (!found.empty() && found.back() == c) continue;
    const auto known = std::find(found.begin(), found.end(), c);
    if (known != found.end()) {
      std::iter_swap(known, found.end() - 1);  // neighbours are alike
      continue;
    }
    if (found.size() == most) return {};
    found.push_back(c);
  }
  return found;
}

bool darker(const Rgb8& a, const Rgb8& b) {
  return std::pair(lightness(a), a) < std::pair(lightness(b), b);
}

}  // namespace

Raster resampled(const Raster& raster, int width, int height) {
  assert(width >= 1 && width <= Weave::kMaxSide && height >= 1 && height <= Weave::kMaxSide);
  if (width == raster.width && height == raster.height) return raster;
  Raster result{width, height, {}};
  result.pixels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  const auto edge = [](int i, int from, int to) { return static_cast<int>(int64_t{i} * from / to); };
  for (int y = 0; y < height; ++y) {
    const int y0 = edge(y, raster.height, height), y1 = std::max(y0 + 1, edge(y + 1, raster.height, height));
    for (int x = 0; x < width; ++x) {
      const int x0 = edge(x, raster.width, width), x1 = std::max(x0 + 1, edge(x + 1, raster.width, width));
      int64_t sum[3] = {0, 0, 0};
      for (int sy = y0; sy < y1; ++sy)
        for (int sx = x0; sx < x1; ++sx)
          for (size_t c = 0; c < 3; ++c) sum[c] += raster.pixels[static_cast<size_t>(sy) * raster.width + sx][c];
      const int64_t n = int64_t{x1 - x0} * (y1 - y0);
      result.pixels.push_back({static_cast<uint8_t>((sum[0] + n / 2) / n), static_cast<uint8_t>((sum[1] + n / 2) / n),
                               static_cast<uint8_t>((sum[2] + n / 2) / n)});
    }
  }
  return result;
}

Raster reducedTo(const Raster& raster, int longestSide) {
  const int longest = std::max(raster.width, raster.height), side = std::min(longest, longestSide);
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(int64_t{length} * side / longest)); };
  return resampled(raster, scaled(raster.width), scaled(raster.height));
}

ColourCounts coloursOf(const Raster& raster) {
  return {binsOf(raster), fewColours(raster, kMostColours)};
}

std::vector<Rgb8> paletteOf(const ColourCounts& counts, int colours) {
  assert(colours >= 1 && colours <= static_cast<int>(kMostColours) && !counts.bins.empty());
  const auto most = static_cast<size_t>(colours);
  std::vector<Rgb8> palette;
  if (counts.few.size() <= most) palette = counts.few;
  if (palette.empty()) {
    const std::vector<Bin>& bins = counts.bins;
    for (const ExactColour& centre : settled(firstCentres(bins, std::min(bins.size(), most)), bins))
      palette.push_back(rounded(centre));
  }
  std::sort(palette.begin(), palette.end(), darker);
  return palette;
}

ReducedPicture reduced(const Raster& raster, std::vector<Rgb8> palette) {
  assert(!palette.empty() && palette.size() <= 32);
  ReducedPicture picture{raster.width, raster.height, {}, std::move(palette), {}};
  std::vector<ExactColour> centres;
  for (const Rgb8& c : picture.palette) centres.push_back(exactly(c));
  bool isExact = true;
  picture.colourOf.reserve(raster.pixels.size());
  const Rgb8* last = nullptr;  // neighbours are mostly alike
  for (const Rgb8& c : raster.pixels) {
    const bool again = last && *last == c;
    picture.colourOf.push_back(again ? picture.colourOf.back() : static_cast<uint8_t>(nearest(centres, exactly(c))));
    isExact = isExact && (again || picture.palette[picture.colourOf.back()] == c);
    last = &c;
  }
  // A drawing in these very colours was made pixel by pixel: it may have lines as thin as one.
  if (!isExact) takeRimsIntoNeighbours(raster, picture.palette, picture.colourOf);
  std::vector<int64_t> counts(picture.palette.size(), 0);
  for (const uint8_t colour : picture.colourOf) ++counts[colour];
  for (const int64_t count : counts)
    picture.shares.push_back(static_cast<double>(count) / static_cast<double>(raster.pixels.size()));
  return picture;
}

Weave weaveOf(const ReducedPicture& picture, const std::vector<Weave>& structures) {
  assert(structures.size() == picture.palette.size());
  std::vector<Weave::SharedRow> rows;
  for (int pick = 0; pick < picture.height; ++pick) {
    Weave::Row row(static_cast<size_t>(picture.width));
    const uint8_t* const colours =
        &picture.colourOf[static_cast<size_t>(picture.height - 1 - pick) * static_cast<size_t>(picture.width)];
    for (int end = 0; end < picture.width; ++end) row[end] = structures[colours[end]].warpOver(pick, end) ? 1 : 0;
    rows.push_back(std::make_shared<const Weave::Row>(std::move(row)));
  }
  return Weave(std::move(rows));
}

}  // namespace loomlight
