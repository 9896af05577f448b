#include "render/transport/light_columns.h"

namespace loomlight {

LightColumns::Kind LightColumns::kindOf(const PathLight& light, std::span<const float> lengths_mm) {
  return {.material = light.sender(), .isWithin = isWithinFibres(lengths_mm)};
}

LightColumns::LightColumns(Kind kind, size_t materials)
    : kind_(kind), perBlock_(lengths_mm() + (kind.isWithin ? materials : 0)) {}

bool LightColumns::add(const PathLight& light, std::span<const float> lengths_mm, uint32_t sample,
                       RecordBudget& budget) {
  const size_t i = size();
  if (!budget.makeRoom(columns_, columns(i + 1)) || !budget.makeRoom(samples_, i + 1)) return false;
  columns_.resize(columns(i + 1));
  samples_.push_back(sample);
  const Rgb radiance = light.arriving();
  for (int c = 0; c < 3; ++c) at(i, kRadiance + static_cast<size_t>(c)) = radiance[c];
  if (isSent()) {
    for (size_t p = 0; p < light.modes.size(); ++p) at(i, kModes + p) = light.modes[p];
    at(i, kTraverse_mm) = light.traverse_mm;
    at(i, kInternalReflectance) = light.internalReflectance;
  }
  if (kind_.isWithin)
    for (size_t k = 0; k < lengths_mm.size(); ++k) at(i, this->lengths_mm() + k) = lengths_mm[k];
  return true;
}

void LightColumns::forgetLast(uint32_t sample) {
  while (!samples_.empty() && samples_.back() == sample) samples_.pop_back();
}

void LightColumns::renumber(std::span<const uint32_t> numbers, RecordBudget& budget) {
  size_t kept = 0;
  for (size_t i = 0; i < size(); ++i) {
    const uint32_t number = numbers[samples_[i]];
    if (number == kNone) continue;
    for (size_t column = 0; column < perBlock_; ++column) at(kept, column) = at(i, column);
    samples_[kept++] = number;
  }
  samples_.resize(kept);
  columns_.resize(columns(kept));
  budget.shrink(samples_);
  budget.shrink(columns_);
}

}  // namespace loomlight
