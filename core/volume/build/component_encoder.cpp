#include "core/volume/build/component_encoder.h"

#include <algorithm>
#include <bit>
#include <utility>

// How it works. Components are fitted and encoded eight at a time. Their density is rounded, so each loses or gains
// some length of fibre. The sum of that is given back at the end, the longest components first: one step of density
// to those that were rounded the wrong way, and then, where anything is left, a few more to any. Lists by exponent
// of the length, made on the way, stand in for sorting.

namespace loomlight {

ComponentEncoder::ComponentEncoder() {
  first_.fill(-1);
}

void ComponentEncoder::encodeBatch() {
  const int count = std::exchange(inBatch_, 0);
  for (int i = count; i % kLanes<Float32x8> != 0; ++i) {  // places that are not used may hold anything that is harmless
    batch_[i] = batch_[0];
    volumes_mm3_[i] = volumes_mm3_[0];
  }
  FittedBatch fitted;
  fitDistributions(batch_, count, fitted);
  std::array<Component, kFitBatch> components;
  for (int i = 0; i < count; i += kLanes<Float32x8>) {
    std::array<DistributionLanes, 2>& eight = fitted[i / kLanes<Float32x8>];
    for (int half = 0; half < 2; ++half) {
      const double* volumes = &volumes_mm3_[i + half * kLanes<Float64x4>];
      eight[half].lengthDensity /= Float64x4{volumes[0], volumes[1], volumes[2], volumes[3]};
    }
    Component::encode(eight, &components[i]);
  }

  auto number = static_cast<int>(encoded_.size());
  encoded_.resize(encoded_.size() + static_cast<size_t>(count));
  for (int i = 0; i < count; ++i, ++number) {
    const double length = batch_[i].length_mm();
    const double kept = components[i].lengthDensity() * volumes_mm3_[i];
    Encoded& one = encoded_[number];
    one.component = components[i].within(boxes_[i]);
    one.volume_mm3 = volumes_mm3_[i];
    one.lost_mm = length - kept;
    lost_mm_ += one.lost_mm;
    if (kept == 0) continue;
    constexpr int kShortest = 1023 - 40;  // the exponent of 2^-40 mm; what is below is of one class with it
    const int exponent = static_cast<int>(std::bit_cast<uint64_t>(length) >> 52);
    int& first = first_[std::clamp(exponent - kShortest, 0, kClasses - 1)];
    one.next = std::exchange(first, number);
  }
}

template <class MayTake>
void ComponentEncoder::give(double maxSteps, const MayTake& mayTake) {
  // Longest first, so that each class finds less lost than the one before.
  for (int c = kClasses - 1; c >= 0; --c) {
    for (int i = first_[c]; i >= 0; i = encoded_[i].next) {
      Encoded& one = encoded_[i];
      if (!mayTake(one)) continue;
      const double density = one.component.lengthDensity();
      const double step_mm = (one.component.withDensitySteps(1).lengthDensity() - density) * one.volume_mm3;
      if (!(std::abs(lost_mm_) > 0.5 * step_mm)) break;  // the others of the class can do little better
      const double steps = std::clamp(lost_mm_ / step_mm, -maxSteps, maxSteps);
      one.component = one.component.withDensitySteps(static_cast<int>(std::lround(steps)));
      lost_mm_ -= (one.component.lengthDensity() - density) * one.volume_mm3;
    }
  }
}

void ComponentEncoder::giveBack() {
  // First to those that were rounded the wrong way: rounded the other way they are still within one step.
  give(1, [this](const Encoded& one) { return one.lost_mm * lost_mm_ > 0; });
  // Rarely is more than that left; steps are a thousandth and less, so some do no harm.
  give(16, [](const Encoded&) { return true; });
}

std::vector<Component> ComponentEncoder::take() {
  if (inBatch_ > 0) encodeBatch();
  giveBack();
  std::vector<Component> components;
  components.reserve(encoded_.size());
  for (const Encoded& one : encoded_) components.push_back(one.component);
  encoded_.clear();
  first_.fill(-1);
  lost_mm_ = 0;
  return components;
}

}  // namespace loomlight
