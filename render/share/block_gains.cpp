#include "render/share/block_gains.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

// How it works. Film and cells are compared in blocks of 2, 4, 8 ... 64 pixels each way. At every size a block trusts
// its own difference, over that of the larger ones around it, by E / (E + N) (empirical Bayes): N is its noise, E how
// large the error of the cells is at this size. That is estimated over the whole picture, by how much further
// differences are apart than their noise explains: from a few blocks, lucky paths would vouch for each other.

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

Rgb BlockGains::Block::gain() const {
  const float least = 1e-3f * std::sqrt(light2) + 1e-12f;  // of no light, none is made
  Rgb gain;
  for (int c = 0; c < 3; ++c) gain[c] = std::max(0.0f, 1 + difference[c] / std::max(least, light[c]));
  return gain;
}

/// Of the difference. Cells that are in the shade here and there let expect more noise than there is in the shade, so
/// the block's own pixels have a say, as far as they are many.
float BlockGains::Block::likelyNoise() const {
  constexpr float kMany = 64;
  const float own = std::max(0.0f, square - glm::dot(difference, difference)) / std::max(1.0f, pixels);
  return (kMany * noise + pixels * own) / (kMany + pixels);
}

Rgb BlockGains::Blocks::gain(float x, float y) const {
  const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
  const float across = x - 0.5f - left, down = y - 0.5f - top;
  const auto gainOf = [&](int i, int j) {
    return at(std::clamp(static_cast<int>(left) + i, 0, width - 1),
              std::clamp(static_cast<int>(top) + j, 0, height - 1))
        .gain();
  };
  return glm::mix(glm::mix(gainOf(0, 0), gainOf(1, 0), across), glm::mix(gainOf(0, 1), gainOf(1, 1), across), down);
}

BlockGains::Blocks BlockGains::smallest(const SharedPicture& shared, const Film& film, int threads) {
  Blocks blocks((shared.width + kSide - 1) / kSide, (shared.height + kSide - 1) / kSide);
  parallelFor(static_cast<size_t>(blocks.height), threads, [&](size_t row) {
    const int top = static_cast<int>(row) * kSide;
    for (int y = top; y < std::min(shared.height, top + kSide); ++y)
      for (int x = 0; x < shared.width; ++x) {
        const uint32_t samples = film.samples(x, y);
        if (samples == 0) continue;
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(shared.width) + static_cast<size_t>(x);
        // Of as much cloth in both, or how much there is of it would pass for light.
        const float alpha = shared.alpha[i];
        const Rgb light = film.alpha(x, y) * shared.light[i], difference = alpha * film.mean(x, y) - light;
        blocks.at(x / kSide, static_cast<int>(row)) +=
            Block{light,
                  difference,
                  alpha * alpha * shared.variances[i] / static_cast<float>(samples),
                  glm::dot(light, light),
                  glm::dot(difference, difference),
                  1};
      }
  });
  return blocks;
}

BlockGains::Blocks BlockGains::ofTwiceTheSize(const Blocks& small) {
  Blocks blocks((small.width + 1) / 2, (small.height + 1) / 2);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) blocks.at(x / 2, y / 2) += small.at(x, y);
  return blocks;
}

/// How large the square of the cells' error is in blocks of this size, beside that in blocks of twice the size, as a
/// share of the square of their light. So much more noise than expected as there may be by chance is no error.
/// `larger`: null for the largest blocks, where it is all of their error.
float BlockGains::relativeError2(const Blocks& blocks, const Blocks* larger) {
  double apart2 = 0, noise = 0, light2 = 0, count = 0;
  for (int y = 0; y < blocks.height; ++y)
    for (int x = 0; x < blocks.width; ++x) {
      const Block& block = blocks.at(x, y);
      if (block.pixels == 0) continue;
      Rgb apart = block.difference;
      float expected = block.noise;
      if (larger) {
        const Block& around = larger->at(x / 2, y / 2);
        apart -= (around.gain() - 1.0f) * block.light;
        expected += around.noise - 2 * block.pixels / around.pixels * block.noise;  // the block is a part of it
      }
      apart2 += glm::dot(apart, apart);
      noise += std::max(0.0f, expected);
      light2 += block.light2;
      ++count;
    }
  if (light2 <= 0) return 0;
  const double chance = 1 + 3 * std::sqrt(kVariesBy / count);
  return static_cast<float>(std::max(0.0, apart2 - chance * noise) / light2);
}

/// From the largest blocks down, differences become what is known of the cells' error.
BlockGains::Blocks BlockGains::freedOfNoise(Blocks smallest) {
  std::vector<Blocks> sizes{std::move(smallest)};
  while (sizes.size() < kSizes) sizes.push_back(ofTwiceTheSize(sizes.back()));
  std::vector<float> errors2;
  for (size_t k = 0; k < kSizes; ++k)
    errors2.push_back(relativeError2(sizes[k], k + 1 < kSizes ? &sizes[k + 1] : nullptr));
  for (size_t k = kSizes; k-- > 0;)
    for (int y = 0; y < sizes[k].height; ++y)
      for (int x = 0; x < sizes[k].width; ++x) {
        Block& block = sizes[k].at(x, y);
        const float middleX = (static_cast<float>(x) + 0.5f) / 2, middleY = (static_cast<float>(y) + 0.5f) / 2;
        const Rgb around = k + 1 < kSizes ? sizes[k + 1].gain(middleX, middleY) : Rgb(1);
        const float error2 = errors2[k] * block.light2;
        const float trust = error2 > 0 && block.pixels > 0 ? error2 / (error2 + block.likelyNoise()) : 0.0f;
        block.difference = glm::mix((around - 1.0f) * block.light, block.difference, trust);
      }
  return std::move(sizes.front());
}

BlockGains::BlockGains(const SharedPicture& shared, const Film& film, int threads)
    : blocks_(freedOfNoise(smallest(shared, film, threads))) {}

Rgb BlockGains::at(int x, int y) const {
  return blocks_.gain((static_cast<float>(x) + 0.5f) / kSide, (static_cast<float>(y) + 0.5f) / kSide);
}

}  // namespace loomlight
