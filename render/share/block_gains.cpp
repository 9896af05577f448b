#include "render/share/block_gains.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "render/share/error_sums.h"

// How it works. Film and cells are compared in blocks of 2, 4, 8 ... 64 pixels each way; where the film has no samples
// yet, films of coarser passes take its place. At every size a block trusts its own difference, over that of the larger
// ones around it, by E / (E + N) (empirical Bayes): N is its noise, E how large the error of the cells is at this size.
// That is estimated over the whole picture, by how much further differences are apart than their noise explains: from a
// few blocks, lucky paths would vouch for each other.

namespace loomlight {
namespace {

constexpr int kSide = 2;      // of the smallest blocks, in pixels
constexpr size_t kSizes = 6;  // of blocks, each twice as wide as the one before
// The square of a mean of some paths varies by 2 of its own squares, and by more where paths are rare.
constexpr float kVariesBy = 4;

}  // namespace

/// What both are means over, weighted by their pixels.
void BlockGains::Block::operator+=(const Block& part) {
  if (part.pixels == 0) return;
  const float all = pixels + part.pixels, more = part.pixels / all;
  light = glm::mix(light, part.light, more);
  difference = glm::mix(difference, part.difference, more);
  noise = (1 - more) * (1 - more) * noise + more * more * part.noise;
  light2 = glm::mix(light2, part.light2, more);
  square = glm::mix(square, part.square, more);
  pixels = all;
}

/// What the cells' light is to be multiplied with for such a difference.
Rgb BlockGains::Block::gain(Rgb difference) const {
  const float least = 1e-3f * std::sqrt(light2) + 1e-12f;  // of no light, none is made
  return glm::max(Rgb(0), 1.0f + difference / glm::max(Rgb(least), light));
}

/// Of the difference. Cells that are in the shade here and there let expect more noise than there is in the shade, so
/// the block's own pixels have a say, as far as they are many.
float BlockGains::Block::likelyNoise() const {
  constexpr float kMany = 64;
  const float own = std::max(0.0f, square - glm::dot(difference, difference)) / std::max(1.0f, pixels);
  return (kMany * noise + pixels * own) / (kMany + pixels);
}

/// Between the centres of blocks; `x` and `y` in blocks from the top left.
Rgb BlockGains::between(const Gains& gains, float x, float y) {
  const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
  const float across = x - 0.5f - left, down = y - 0.5f - top;
  const int x0 = std::max(0, static_cast<int>(left)), x1 = std::min(static_cast<int>(left) + 1, gains.width - 1);
  const int y0 = std::max(0, static_cast<int>(top)), y1 = std::min(static_cast<int>(top) + 1, gains.height - 1);
  return glm::mix(glm::mix(gains.at(x0, y0), gains.at(x1, y0), across),
                  glm::mix(gains.at(x0, y1), gains.at(x1, y1), across), down);
}

/// What is known of a pixel at full resolution. Those of one coarse pixel have its samples together: in the mean over
/// all of them they count for one pixel and have its noise, and over some of them they have more.
BlockGains::Block BlockGains::Compared::at(int x, int y) const {
  const int u = x / divider, v = y / divider;
  const uint32_t samples = film.samples(u, v);
  if (samples == 0) return {};
  const size_t i = pixelIndex(u, v, shared.width);
  // Of as much cloth in both, or how much there is of it would pass for light.
  const float alpha = shared.alpha[i], together = static_cast<float>(divider * divider);
  const Rgb light = film.alpha(u, v) * shared.light[i], difference = alpha * film.mean(u, v) - light;
  return {light,
          difference,
          together * alpha * alpha * shared.variances[i] / static_cast<float>(samples),
          glm::dot(light, light),
          glm::dot(difference, difference),
          1 / together};
}

BlockGains::Grid<BlockGains::Block> BlockGains::smallest(std::span<const Compared> finestFirst, int threads) {
  const SharedPicture& shared = finestFirst.front().shared;
  Grid<Block> blocks(coarser(shared.width, kSide), coarser(shared.height, kSide));
  parallelFor(static_cast<size_t>(blocks.height), threads, [&](size_t row) {
    const int top = static_cast<int>(row) * kSide;
    for (int y = top; y < std::min(shared.height, top + kSide); ++y)
      for (int x = 0; x < shared.width; ++x) {
        Block pixel;
        for (size_t k = 0; k < finestFirst.size() && pixel.pixels == 0; ++k) pixel = finestFirst[k].at(x, y);
        blocks.at(x / kSide, static_cast<int>(row)) += pixel;
      }
  });
  return blocks;
}

BlockGains::Grid<BlockGains::Block> BlockGains::ofTwiceTheSize(const Grid<Block>& small) {
  Grid<Block> blocks((small.width + 1) / 2, (small.height + 1) / 2);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) blocks.at(x / 2, y / 2) += small.at(x, y);
  return blocks;
}

/// How large the square of the cells' error is in blocks of this size, beside that in blocks of twice the size, as a
/// share of the square of their light. `larger`: null for the largest blocks, where it is all of their error.
float BlockGains::relativeError2(const Grid<Block>& blocks, const Grid<Block>* larger) {
  ErrorSums sums;
  for (int y = 0; y < blocks.height; ++y)
    for (int x = 0; x < blocks.width; ++x) {
      const Block& block = blocks.at(x, y);
      if (block.pixels < 1) continue;  // a part of a coarse pixel is no smaller block than that
      Rgb apart = block.difference;
      float expected = block.noise;
      if (larger) {
        const Block& around = larger->at(x / 2, y / 2);
        apart -= (around.gain(around.difference) - 1.0f) * block.light;
        expected += around.noise - 2 * block.pixels / around.pixels * block.noise;  // the block is a part of it
      }
      sums += {glm::dot(apart, apart), std::max(0.0f, expected), block.light2, 1};
    }
  return sums.relativeError2(kVariesBy);
}

/// From the largest blocks down, differences become what is known of the cells' error.
BlockGains::Gains BlockGains::freedOfNoise(Grid<Block> smallest) {
  std::vector<Grid<Block>> sizes{std::move(smallest)};
  while (sizes.size() < kSizes) sizes.push_back(ofTwiceTheSize(sizes.back()));
  Gains larger((sizes.back().width + 1) / 2, (sizes.back().height + 1) / 2);
  std::ranges::fill(larger.all, Rgb(1));  // still larger ones are as the cells have it
  for (size_t k = kSizes; k-- > 0;) {
    const Grid<Block>& blocks = sizes[k];
    const float relative2 = relativeError2(blocks, k + 1 < kSizes ? &sizes[k + 1] : nullptr);
    Gains gains(blocks.width, blocks.height);
    for (int y = 0; y < blocks.height; ++y)
      for (int x = 0; x < blocks.width; ++x) {
        const Block& block = blocks.at(x, y);
        const Rgb around = between(larger, (static_cast<float>(x) + 0.5f) / 2, (static_cast<float>(y) + 0.5f) / 2);
        const float error2 = relative2 * block.light2;
        const float trust = error2 > 0 ? error2 / (error2 + block.likelyNoise()) : 0.0f;
        gains.at(x, y) =
            block.pixels > 0 ? block.gain(glm::mix((around - 1.0f) * block.light, block.difference, trust)) : around;
      }
    larger = std::move(gains);
  }
  return larger;
}

BlockGains::BlockGains(const SharedPicture& shared, const Film& film, std::span<const CoarseFilm> coarser, int threads)
    : gains_(0, 0) {
  std::vector<SharedPicture> reducedTo;
  for (const CoarseFilm& coarse : coarser) reducedTo.push_back(reduced(shared, coarse.divider));
  std::vector<Compared> finestFirst{{shared, film, 1}};
  for (size_t k = coarser.size(); k-- > 0;) finestFirst.push_back({reducedTo[k], coarser[k].film, coarser[k].divider});
  gains_ = freedOfNoise(smallest(finestFirst, threads));
}

Rgb BlockGains::at(glm::vec2 place) const {
  return between(gains_, place.x / kSide, place.y / kSide);
}

}  // namespace loomlight
