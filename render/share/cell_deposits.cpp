#include "render/share/cell_deposits.h"

#include "render/share/first_fibres.h"

namespace loomlight {

void CellDeposits::begin(size_t tiles) {
  tiles_ = std::vector<Tile>(tiles, Tile(scene_));
}

void CellDeposits::sample(size_t tile, int x, int y, const Ray& ray, const Collision* first, const PathSample& sample) {
  Tile& own = tiles_[tile];
  const auto pixel = static_cast<uint32_t>(ofPixels_ ? hits_.pixelAt(x, y) : 0);
  if (!first) {
    if (ofPixels_ && !hits_.isFull(pixel))
      own.deposits.push_back({pixel, FirstHits::missed(goesThrough(scene_, ray)), Rgb(0)});
    return;
  }
  const LightCellPath path = own.keys.of(*first);
  const auto cell = cells_.find(path);
  own.deposits.push_back({pixel, cell.value_or(FirstHits::kNew), sample.direct + sample.indirect});
  if (!cell) own.fresh.push_back(path);
}

void CellDeposits::settle() {
  for (const Tile& tile : tiles_) {
    auto fresh = tile.fresh.begin();
    for (const Deposit& one : tile.deposits) {
      const uint32_t cell = one.cell == FirstHits::kNew ? cells_.add(*fresh++) : one.cell;
      if (FirstHits::isCell(cell)) cells_.deposit(cell, one.colour);
      if (ofPixels_) hits_.put(one.pixel, cell);
    }
  }
  tiles_.clear();
}

}  // namespace loomlight
