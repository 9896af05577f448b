#include "render/transport/path_records.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"
#include "render/transport/light_lanes.h"

// How it works. Of each tile of the picture there is a list of samples, and all that their colour depends on but the
// dyes: their lights, kind by kind, in columns of numbers. Other dyes are then one pass over these columns, which adds
// to each sample the colours of its lights, a register of lights at a time, and another over the samples. Beside the
// sums of both colours it gives those of their squares and products, from which render/display/recolour.cpp knows the
// noise of their ratio.
//
// Lights of a sample are summed kind by kind, and within a kind as they were met, whoever traced them and when.
namespace loomlight {
namespace {

/// From sums of products to those of products of what differs from the means; one sample differs by nothing.
void moveToMeans(PathRecords::Sums& s) {
  if (s.samples == 0) return;
  const auto n = static_cast<float>(s.samples);
  s.tracedTraced = n > 1 ? s.tracedTraced - s.traced * s.traced / n : Rgb(0.0f);
  s.tracedRecoloured = n > 1 ? s.tracedRecoloured - s.traced * s.recoloured / n : Rgb(0.0f);
  s.recolouredRecoloured = n > 1 ? s.recolouredRecoloured - s.recoloured * s.recoloured / n : Rgb(0.0f);
}

}  // namespace

void PathLog::clear() {
  lights_.clear();
  lengths_mm_.clear();
}

void PathLog::gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t) {
  lights_.push_back(light);
  lengths_mm_.insert(lengths_mm_.end(), lengths_mm.begin(), lengths_mm.end());
}

PathRecords::PathRecords(int width, int height, int materials, size_t bytes)
    : width_(width),
      height_(height),
      materials_(static_cast<size_t>(materials)),
      columns_(static_cast<size_t>((width + kTile - 1) / kTile)),
      budget_(bytes),
      tiles_(columns_ * static_cast<size_t>((height + kTile - 1) / kTile)) {}

bool PathRecords::takes(int x, int y, uint32_t index) const {
  return !budget_.isExhausted() && samples(x, y) == index;
}

void PathRecords::add(int x, int y, Rgb colour, const PathLog& log) {
  Tile& tile = tileOf(x, y);
  if (!budget_.makeRoom(tile.samples, tile.samples.size() + 1)) return;
  if (!addLights(tile, log)) {
    for (LightColumns& lights : tile.lights) lights.forgetLast(static_cast<uint32_t>(tile.samples.size()));
    return;
  }
  tile.samples.push_back({colour, inTile(x, y)});
  ++tile.kept[inTile(x, y)];
}

/// Of the next sample. False where there is no room for all of them.
bool PathRecords::addLights(Tile& tile, const PathLog& log) {
  const auto sample = static_cast<uint32_t>(tile.samples.size());
  for (size_t i = 0; i < log.size(); ++i) {
    const LightColumns::Kind kind = LightColumns::kindOf(log.light(i), log.lengths_mm(i));
    auto of = std::ranges::lower_bound(tile.lights, kind, {}, &LightColumns::kind);
    if (of == tile.lights.end() || of->kind() != kind) {
      const auto place = of - tile.lights.begin();
      if (!budget_.makeRoom(tile.lights, tile.lights.size() + 1)) return false;
      of = tile.lights.emplace(tile.lights.begin() + place, kind, materials_);
    }
    if (!of->add(log.light(i), log.lengths_mm(i), sample, budget_)) return false;
  }
  return true;
}

void PathRecords::settle() {
  if (!budget_.isExhausted() || settled_) return;
  settled_ = true;
  uint32_t fewest = std::numeric_limits<uint32_t>::max();
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) fewest = std::min(fewest, samples(x, y));
  for (Tile& tile : tiles_) cut(tile, fewest);
}

void PathRecords::cut(Tile& tile, uint32_t samples) {
  std::vector<uint32_t> numbers;  // that samples get; of those that are dropped: kNone
  tile.kept.fill(0);
  uint32_t kept = 0;
  for (const Sample& sample : tile.samples) {
    uint32_t& ofPixel = tile.kept[sample.pixel];
    const bool isKept = ofPixel < samples;
    numbers.push_back(isKept ? kept : LightColumns::kNone);
    if (!isKept) continue;
    tile.samples[kept++] = sample;
    ++ofPixel;
  }
  tile.samples.resize(kept);
  budget_.shrink(tile.samples);
  for (LightColumns& lights : tile.lights) lights.renumber(numbers, budget_);
  std::erase_if(tile.lights, [](const LightColumns& lights) { return lights.size() == 0; });
  budget_.shrink(tile.lights);
}

std::array<PathRecords::Sums, PathRecords::kTile * PathRecords::kTile> PathRecords::sum(
    const Tile& tile, const Recolouring& recolouring) {
  std::vector<Rgb> recoloured(tile.samples.size(), Rgb(0.0f));
  for (const LightColumns& lights : tile.lights)
    addColours(lights, recolouring.colouring, recolouring.light, recoloured);
  std::array<Sums, kTile * kTile> sums{};
  for (size_t i = 0; i < recoloured.size(); ++i) {
    const Rgb was = tile.samples[i].traced, is = recoloured[i];
    Sums& ofPixel = sums[tile.samples[i].pixel];
    ofPixel.traced += was;
    ofPixel.recoloured += is;
    ofPixel.tracedTraced += was * was;
    ofPixel.tracedRecoloured += was * is;
    ofPixel.recolouredRecoloured += is * is;
    ++ofPixel.samples;
  }
  for (Sums& ofPixel : sums) moveToMeans(ofPixel);
  return sums;
}

std::vector<PathRecords::Sums> PathRecords::recoloured(const Recolouring& recolouring, const PixelRect& window,
                                                       int threads) const {
  std::vector<Sums> picture(pixelCount(window.width, window.height));
  parallelFor(tiles_.size(), threads, [&](size_t i) {
    const int column = static_cast<int>(i % columns_) * kTile, row = static_cast<int>(i / columns_) * kTile;
    const int left = std::max(column, window.x), right = std::min(column + kTile, window.x + window.width);
    const int top = std::max(row, window.y), bottom = std::min(row + kTile, window.y + window.height);
    if (left >= right || top >= bottom) return;
    const std::array<Sums, kTile * kTile> sums = sum(tiles_[i], recolouring);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        picture[pixelIndex(x - window.x, y - window.y, window.width)] = sums[inTile(x, y)];
  });
  return picture;
}

}  // namespace loomlight
