#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/geometry/cloth_geometry.h"

namespace loomlight {

/// Numbers the shapes of cells, that is keys up to the phase, in the order in which they are met.
class ShapeTable {
 public:
  explicit ShapeTable(const ClothGeometry& geometry, System system) : geometry_(&geometry), system_(system) {}

  /// Of the shape with this code; a handful of instructions for those met lately.
  uint32_t number(ClothGeometry::ShapeCode code) {
    Recent& recent = recent_[(code * 0x9E3779B97F4A7C15ull) >> (64 - kRecentBits)];
    if (recent.code != code) recent = {code, numberOf(code)};
    return recent.number;
  }
  /// Of the shape of a key, whose phase must be 0.
  uint32_t number(const CellKey& shape);

  const std::vector<CellKey>& shapes() const { return shapes_; }

 private:
  struct KeyHash {
    size_t operator()(const CellKey& key) const { return hash(key); }
  };
  struct Recent {
    ClothGeometry::ShapeCode code = ~ClothGeometry::ShapeCode{0};  ///< no shape has this one
    uint32_t number = 0;
  };
  static constexpr int kRecentBits = 10;

  uint32_t numberOf(ClothGeometry::ShapeCode code);

  const ClothGeometry* geometry_;
  System system_;
  std::vector<CellKey> shapes_;
  std::unordered_map<CellKey, uint32_t, KeyHash> numbers_;
  std::unordered_map<ClothGeometry::ShapeCode, uint32_t> numbersOfCodes_;
  std::vector<Recent> recent_ = std::vector<Recent>(size_t{1} << kRecentBits);
};

}  // namespace loomlight
