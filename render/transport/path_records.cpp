#include "render/transport/path_records.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"
#include "render/transport/light_batches.h"

// How it works. Samples are written one behind the other into a strip of numbers for each tile, with all that their
// colour depends on but the dyes. Other dyes are then one pass over the strip, in which the lights of all samples get
// their colours side by side, and another, which adds these up sample by sample. Beside the sums of both colours it
// gives those of their squares and products, from which render/display/recolour.cpp knows the noise of their ratio.
namespace loomlight {
namespace {

// A sample: which pixel of the tile, how many words its light takes, its colour when it was traced, its light. Light:
// which fibre sent it (0: none, k + 1: one of material k), radiance, the lengths, and if there is such a fibre, what it
// did.
constexpr size_t kSampleHead = 5, kLightHead = 4, kFibreWords = FibreBcsdf::kLobes + 2;

}  // namespace

void PathLog::gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t) {
  const bool fromFibre = light.traverse_mm > 0;
  words_.push_back(fromFibre ? static_cast<float>(light.material + 1) : 0.0f);
  for (int c = 0; c < 3; ++c) words_.push_back(light.radiance[c]);
  words_.insert(words_.end(), lengths_mm.begin(), lengths_mm.end());
  if (!fromFibre) return;
  words_.insert(words_.end(), light.modes.begin(), light.modes.end());
  words_.push_back(light.traverse_mm);
  words_.push_back(light.inside);
}

PathRecords::PathRecords(int width, int height, int materials, size_t bytes)
    : width_(width),
      height_(height),
      materials_(static_cast<size_t>(materials)),
      columns_(static_cast<size_t>((width + kTile - 1) / kTile)),
      budget_(bytes),
      tiles_(columns_ * static_cast<size_t>((height + kTile - 1) / kTile)) {}

bool PathRecords::takes(int x, int y, uint32_t index) const {
  return !full_.load(std::memory_order_relaxed) && samples(x, y) == index;
}

/// Grows by a quarter, so that little memory is held in reserve. False when there is none left.
bool PathRecords::makeRoom(std::vector<float>& words, size_t more) {
  const size_t now = words.capacity(), needed = words.size() + more;
  if (needed <= now) return true;
  const size_t then = std::max(needed, now + now / 4);
  const size_t grown = (then - now) * sizeof(float);
  if (bytes_.fetch_add(grown) + grown > budget_) {
    bytes_ -= grown;
    full_ = true;
    return false;
  }
  words.reserve(then);
  return true;
}

void PathRecords::add(int x, int y, Rgb colour, const PathLog& log) {
  Tile& tile = tileOf(x, y);
  const std::span<const float> light = log.words();
  if (!makeRoom(tile.words, kSampleHead + light.size())) return;
  tile.words.insert(tile.words.end(), {static_cast<float>(inTile(x, y)), static_cast<float>(light.size()), colour.r,
                                       colour.g, colour.b});  // sizes stay below 2^24: exact
  tile.words.insert(tile.words.end(), light.begin(), light.end());
  ++tile.samples[inTile(x, y)];
}

void PathRecords::settle() {
  if (!full_ || settled_) return;
  settled_ = true;
  uint32_t fewest = std::numeric_limits<uint32_t>::max();
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) fewest = std::min(fewest, samples(x, y));
  for (Tile& tile : tiles_) cut(tile, fewest);
}

void PathRecords::cut(Tile& tile, uint32_t samples) {
  std::array<uint32_t, kTile * kTile> kept{};
  std::vector<float> words;
  for (auto sample = tile.words.begin(); sample != tile.words.end();) {
    const auto next = sample + static_cast<ptrdiff_t>(kSampleHead + static_cast<size_t>(sample[1]));
    uint32_t& count = kept[static_cast<size_t>(sample[0])];
    if (count < samples) {
      words.insert(words.end(), sample, next);
      ++count;
    }
    sample = next;
  }
  words.shrink_to_fit();
  bytes_ -= (tile.words.capacity() - words.capacity()) * sizeof(float);
  tile.words = std::move(words);
  tile.samples = kept;
}

PathRecords::Recorded PathRecords::lightAt(const float* word, Rgb lamp) const {
  Recorded found{{}, {word + kLightHead, materials_}, word + kLightHead + materials_};
  PathLight& light = found.light;
  light.radiance = lamp * Rgb(word[1], word[2], word[3]);
  const auto fibre = static_cast<int>(word[0]);
  if (fibre == 0) return found;
  light.material = fibre - 1;
  std::copy_n(found.next, FibreBcsdf::kLobes, light.modes.begin());
  light.traverse_mm = found.next[FibreBcsdf::kLobes];
  light.inside = found.next[FibreBcsdf::kLobes + 1];
  found.next += kFibreWords;
  return found;
}

void PathRecords::Sums::add(Rgb asTraced, Rgb inOtherColours) {
  traced += asTraced;
  recoloured += inOtherColours;
  tracedTraced += asTraced * asTraced;
  tracedRecoloured += asTraced * inOtherColours;
  recolouredRecoloured += inOtherColours * inOtherColours;
  ++samples;
}

void PathRecords::sum(const Tile& tile, const Recolouring& recolouring, std::span<Sums> sums) const {
  if (recolouring.colouring.isSpectral())
    sumInBands(tile, recolouring, sums);
  else
    sumOfThree(tile, recolouring, sums);
}

/// Three numbers take so little that each light is coloured as it is read.
void PathRecords::sumOfThree(const Tile& tile, const Recolouring& recolouring, std::span<Sums> sums) const {
  const float* const end = tile.words.data() + tile.words.size();
  for (const float* word = tile.words.data(); word < end;) {
    const float* const sample = word;
    const float* const next = word + kSampleHead + static_cast<size_t>(word[1]);
    Rgb recoloured(0.0f);
    for (word += kSampleHead; word < next;) {
      const Recorded one = lightAt(word, recolouring.light);
      recoloured += colourOf(one.light, one.lengths_mm, recolouring.colouring);
      word = one.next;
    }
    sums[static_cast<size_t>(sample[0])].add(Rgb(sample[2], sample[3], sample[4]), recoloured);
  }
}

/// Lights are gathered first, and then coloured many at a time.
void PathRecords::sumInBands(const Tile& tile, const Recolouring& recolouring, std::span<Sums> sums) const {
  const float* const end = tile.words.data() + tile.words.size();
  LightBatches lights(recolouring.colouring, materials_, tile.words.size() / (kLightHead + materials_));
  std::vector<uint32_t> lightsOf;  // each sample
  for (const float* word = tile.words.data(); word < end;) {
    const float* const next = word + kSampleHead + static_cast<size_t>(word[1]);
    uint32_t& count = lightsOf.emplace_back(0);
    for (word += kSampleHead; word < next; ++count) {
      const Recorded one = lightAt(word, recolouring.light);
      lights.add(one.light, one.lengths_mm);
      word = one.next;
    }
  }
  const float* sample = tile.words.data();
  const Rgb* colour = lights.colours().data();
  for (const uint32_t count : lightsOf) {
    Rgb recoloured(0.0f);
    for (uint32_t i = 0; i < count; ++i) recoloured += *colour++;
    sums[static_cast<size_t>(sample[0])].add(Rgb(sample[2], sample[3], sample[4]), recoloured);
    sample += kSampleHead + static_cast<size_t>(sample[1]);
  }
}

std::vector<PathRecords::Sums> PathRecords::recoloured(const Recolouring& recolouring, const PixelRect& window,
                                                       int threads) const {
  std::vector<Sums> picture(static_cast<size_t>(window.width) * static_cast<size_t>(window.height));
  parallelFor(tiles_.size(), threads, [&](size_t i) {
    const int column = static_cast<int>(i % columns_) * kTile, row = static_cast<int>(i / columns_) * kTile;
    const int left = std::max(column, window.x), right = std::min(column + kTile, window.x + window.width);
    const int top = std::max(row, window.y), bottom = std::min(row + kTile, window.y + window.height);
    if (left >= right || top >= bottom) return;
    std::array<Sums, kTile * kTile> sums{};
    sum(tiles_[i], recolouring, sums);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        picture[static_cast<size_t>(y - window.y) * static_cast<size_t>(window.width) +
                static_cast<size_t>(x - window.x)] = sums[inTile(x, y)];
  });
  return picture;
}

}  // namespace loomlight
