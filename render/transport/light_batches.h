#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/transport/light_lanes.h"
#include "render/transport/path_light.h"

namespace loomlight {

/// Gives many lights that paths have met their colours, faster than one by one: those that need the same are gathered
/// until as many are together as are computed side by side. The colours are colourOf() of each, to the bit. For cloth
/// with fibres that are known in bands: lights of others take so little that gathering them would cost more.
class LightBatches {
 public:
  /// Memory is made ready for so many lights at most; more may come.
  LightBatches(const Colouring& colouring, size_t materials, size_t most = 0);

  void add(const PathLight& light, std::span<const float> lengths_mm);
  /// Of all lights that were added, in that order.
  std::span<const Rgb> colours();

 private:
  struct Batch {
    LightLanes lights;
    size_t count = 0;
    std::array<size_t, kWalkLanes> places{};  ///< among colours_
  };
  void finish(Batch& batch);

  const Colouring& colouring_;
  std::vector<std::unique_ptr<Batch>> batches_;  ///< two for no fibre and for each material; null: not met yet
  std::vector<Rgb> colours_;
};

}  // namespace loomlight
