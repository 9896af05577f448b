#include "core/volume/shape_table.h"

namespace loomlight {

uint32_t ShapeTable::number(const CellKey& shape) {
  const auto [found, isNew] = numbers_.try_emplace(shape, static_cast<uint32_t>(shapes_.size()));
  if (isNew) shapes_.push_back(shape);
  return found->second;
}

uint32_t ShapeTable::numberOf(ClothGeometry::ShapeCode code) {
  const auto found = numbersOfCodes_.find(code);
  if (found != numbersOfCodes_.end()) return found->second;
  const uint32_t result = number(geometry_->shapeKey(system_, code));
  numbersOfCodes_.emplace(code, result);
  return result;
}

}  // namespace loomlight
