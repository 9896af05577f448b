#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "render/transport/path_light.h"
#include "render/transport/record_budget.h"
#include "render/walk/walk_lanes.h"

namespace loomlight {

/// Lights of one kind that samples of pixels have met, uncoloured, in the form in which registers are loaded: in blocks
/// of kWalkLanes lights, each of which is columns with one number of each light. What a kind does not have takes no
/// memory.
class LightColumns {
 public:
  /// Of lights that need the same to get their colours.
  struct Kind {
    int material = PathLight::kNoFibre;  ///< PathLight::sender()
    bool isWithin = false;               ///< whether their paths have been inside of fibres
    auto operator<=>(const Kind&) const = default;
  };
  static Kind kindOf(const PathLight& light, std::span<const float> lengths_mm);

  struct alignas(64) Column {
    LaneFloats lanes{};  ///< where there is no light: finite, and not negative
  };
  static constexpr uint32_t kNone = UINT32_MAX;  ///< no sample

  /// For a scene with so many materials.
  LightColumns(Kind kind, size_t materials);

  const Kind& kind() const { return kind_; }
  size_t size() const { return samples_.size(); }
  /// The sample that has met each light; they ascend.
  std::span<const uint32_t> samples() const { return samples_; }
  /// The columns of the block in which a light is; it is number light % kWalkLanes there.
  const Column* block(size_t light) const { return &columns_[light / kWalkLanes * perBlock_]; }
  // Which of these is what, if the kind has it: three primaries of PathLight::arriving(), ...
  static constexpr size_t kRadiance = 0;
  // ... if fibres sent the lights, their PathLight::modes, traverse_mm and internalReflectance, ...
  static constexpr size_t kModes = 3, kTraverse_mm = kModes + FibreBcsdf::kModes,
                          kInternalReflectance = kTraverse_mm + 1;
  // ... and if they have been within fibres, the lengths there, of each material.
  size_t lengths_mm() const { return isSent() ? kInternalReflectance + 1 : kModes; }

  /// A light of this kind. False where there is no room.
  bool add(const PathLight& light, std::span<const float> lengths_mm, uint32_t sample, RecordBudget& budget);
  /// Forgets all lights of this sample, the last one.
  void forgetLast(uint32_t sample);
  /// Sample i becomes numbers[i], which ascend too; lights of those that become kNone are forgotten. Keeps no memory in
  /// reserve.
  void renumber(std::span<const uint32_t> numbers, RecordBudget& budget);

 private:
  bool isSent() const { return kind_.material != PathLight::kNoFibre; }
  /// Of so many lights.
  size_t columns(size_t lights) const { return (lights + kWalkLanes - 1) / kWalkLanes * perBlock_; }
  /// The number of a light in a column of its block.
  float& at(size_t light, size_t column) {
    return columns_[light / kWalkLanes * perBlock_ + column].lanes[light % kWalkLanes];
  }

  Kind kind_;
  size_t perBlock_;
  std::vector<Column> columns_;  ///< block after block
  std::vector<uint32_t> samples_;
};

}  // namespace loomlight
