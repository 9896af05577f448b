#include "core/volume/component_encoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace loomlight {

void ComponentEncoder::add(const FibreMoments& moments, double volume_mm3, int material) {
  batch_[inBatch_] = moments;
  batchVolumes_mm3_[inBatch_] = volume_mm3;
  batchMaterials_[inBatch_] = material;
  if (++inBatch_ == kFitBatch) encodeBatch();
}

void ComponentEncoder::encodeBatch() {
  const int count = std::exchange(inBatch_, 0);
  for (int i = count; i % kLanes != 0; ++i) {  // lanes that are not used may hold anything that is harmless
    batch_[i] = batch_[0];
    batchVolumes_mm3_[i] = batchVolumes_mm3_[0];
    batchMaterials_[i] = 0;
  }
  FittedBatch fitted;
  fitDistributions(batch_, count, fitted);
  std::array<Component, kFitBatch> encoded;
  for (int i = 0; i < count; i += kLanes) {
    DistributionLanes& four = fitted[i / kLanes];
    const double* volumes = &batchVolumes_mm3_[i];
    const int* materials = &batchMaterials_[i];
    four.lengthDensity /= Lanes{volumes[0], volumes[1], volumes[2], volumes[3]};
    four.material = IntLanes{materials[0], materials[1], materials[2], materials[3]};
    Component::encode(four, &encoded[i]);
  }
  for (int i = 0; i < count; ++i) {
    components_.push_back(encoded[i]);
    const double volume = batchVolumes_mm3_[i];
    rounded_.push_back({volume, batch_[i].length_mm() - encoded[i].lengthDensity() * volume});
  }
}

void ComponentEncoder::giveBack() {
  // Longest first, so that each finds less lost than the one before: by powers of two of the length.
  constexpr int kClasses = 64, kShortest = 1023 - 40;  // the exponent of 2^-40 mm; those below are one class with it
  std::array<int, kClasses> first;
  first.fill(-1);
  std::vector<int> next(components_.size());
  double lost_mm = 0;
  for (size_t i = 0; i < components_.size(); ++i) {
    lost_mm += rounded_[i].lost_mm;
    const double length = components_[i].lengthDensity() * rounded_[i].volume_mm3;
    if (length == 0) continue;
    const int exponent = static_cast<int>(std::bit_cast<uint64_t>(length) >> 52);
    int& head = first[std::clamp(exponent - kShortest, 0, kClasses - 1)];
    next[i] = head;
    head = static_cast<int>(i);
  }
  const auto give = [&](double maxSteps, auto&& mayTake) {
    for (int c = kClasses - 1; c >= 0; --c) {
      for (int i = first[c]; i >= 0; i = next[i]) {
        if (!mayTake(i)) continue;
        Component& component = components_[i];
        const double density = component.lengthDensity();
        const double step_mm = (component.withDensitySteps(1).lengthDensity() - density) * rounded_[i].volume_mm3;
        const double steps = std::clamp(lost_mm / step_mm, -maxSteps, maxSteps);
        if (!(std::abs(steps) > 0.5)) break;  // the others of the class can do little better
        component = component.withDensitySteps(static_cast<int>(std::lround(steps)));
        lost_mm -= (component.lengthDensity() - density) * rounded_[i].volume_mm3;
      }
    }
  };
  // First those that were rounded the wrong way: rounded the other way they are still within one step.
  give(1, [&](int i) { return rounded_[i].lost_mm * lost_mm > 0; });
  // Rarely is more than that left; steps are a thousandth and less, so some do no harm.
  give(16, [](int) { return true; });
}

std::vector<Component> ComponentEncoder::take() {
  if (inBatch_ > 0) encodeBatch();
  giveBack();
  return std::move(components_);
}

}  // namespace loomlight
