#include "core/volume/shape_table.h"

namespace loomlight {

uint32_t ShapeTable::numberOf(ClothGeometry::ShapeCode code) {
  if (known_)
    if (const auto found = known_->numbersOfCodes_.find(code); found != known_->numbersOfCodes_.end())
      return found->second;
  if (const auto found = numbersOfCodes_.find(code); found != numbersOfCodes_.end()) return found->second;
  // Another code may have the same shape.
  const CellKey shape = geometry_->shapeKey(system_, code);
  if (known_)
    if (const auto found = known_->numbers_.find(shape); found != known_->numbers_.end())
      return numbersOfCodes_.emplace(code, found->second).first->second;
  const auto [entry, isNew] = numbers_.try_emplace(shape, end());
  if (isNew) {
    shapes_.push_back(shape);
    codes_.push_back(code);
  }
  numbersOfCodes_.emplace(code, entry->second);
  return entry->second;
}

}  // namespace loomlight
