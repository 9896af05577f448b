#include "core/volume/tiles/shape_table.h"

#include <algorithm>

// How it works. A code is what the geometry can tell of a shape without computing it, and several codes may be of one
// shape. So a code is looked up first, in a small table of those met lately and then among all; only a code that is new
// costs the shape itself, which is then looked for among the shapes. For an edit's few cells a search from one end is
// quicker than making an index of thousands of shapes.
namespace loomlight {

void ShapeTable::index() {
  if (indexed_) return;
  indexed_ = true;
  for (uint32_t number = first_; number < end(); ++number) {
    numbers_.emplace(shape(number), number);
    numbersOfCodes_.emplace(code(number), number);
  }
}

uint32_t ShapeTable::add(ShapeCode code, const YarnCellKey& shape) {
  shapes_.push_back(shape);
  codes_.push_back(code);
  return end() - 1;
}

uint32_t ShapeTable::search(ShapeCode code) {
  if (const auto found = std::find(codes_.begin(), codes_.end(), code); found != codes_.end())
    return static_cast<uint32_t>(found - codes_.begin());
  // Another code may have the same shape.
  const YarnCellKey shape = geometry_->shapeKey(system_, code);
  const auto found = std::find(shapes_.begin(), shapes_.end(), shape);
  return found != shapes_.end() ? static_cast<uint32_t>(found - shapes_.begin()) : add(code, shape);
}

uint32_t ShapeTable::numberOf(ShapeCode code) {
  if (!indexed_) {
    if (++searches_ <= kFewSearches) return search(code);
    index();
  }
  if (known_)
    if (const auto found = known_->numbersOfCodes_.find(code); found != known_->numbersOfCodes_.end())
      return found->second;
  if (const auto found = numbersOfCodes_.find(code); found != numbersOfCodes_.end()) return found->second;
  const YarnCellKey shape = geometry_->shapeKey(system_, code);
  if (known_)
    if (const auto found = known_->numbers_.find(shape); found != known_->numbers_.end())
      return numbersOfCodes_.emplace(code, found->second).first->second;
  const auto [entry, isNew] = numbers_.try_emplace(shape, end());
  if (isNew) add(code, shape);
  numbersOfCodes_.emplace(code, entry->second);
  return entry->second;
}

}  // namespace loomlight
