#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight {

/// Numbers the shapes of cells, that is keys up to phase and stretch, in the order in which they are met.
class ShapeTable {
 public:
  ShapeTable(const ClothGeometry& geometry, System system) : geometry_(&geometry), system_(system) {}
  /// `known`: shapes that have numbers already. It must be indexed, stay, and not be changed meanwhile.
  ShapeTable(const ClothGeometry& geometry, System system, const ShapeTable& known)
      : geometry_(&geometry), system_(system), known_(&known), first_(known.end()) {}
  /// Of shapes that have numbers already, and one code of each: for looking up some few more. Not indexed.
  ShapeTable(const ClothGeometry& geometry, System system, std::vector<YarnCellKey> shapes,
             std::vector<ShapeCode> codes)
      : geometry_(&geometry), system_(system), shapes_(std::move(shapes)), codes_(std::move(codes)), indexed_(false) {}

  /// Of the shape with this code; a handful of instructions for those met lately.
  uint32_t number(ShapeCode code) {
    Recent& recent = recent_[(code * 0x9E3779B97F4A7C15ull) >> (64 - kRecentBits)];
    if (recent.code != code) recent = {code, numberOf(code)};
    return recent.number;
  }

  /// Makes number() quick for a whole cloth. A table that is asked about a few cells alone does without.
  void index();

  /// The numbers from here to the end are those of the shapes that were not known.
  uint32_t first() const { return first_; }
  uint32_t end() const { return first_ + static_cast<uint32_t>(shapes_.size()); }
  const YarnCellKey& shape(uint32_t number) const { return shapes_[number - first_]; }  ///< first() <= number < end()
  /// The first that was met of the codes of this shape.
  ShapeCode code(uint32_t number) const { return codes_[number - first_]; }

 private:
  struct Recent {
    ShapeCode code = ~ShapeCode{0};  ///< no shape has this one
    uint32_t number = 0;
  };
  static constexpr int kRecentBits = 10;
  static constexpr int kFewSearches = 64;  ///< so many searches one by one cost less than an index

  uint32_t numberOf(ShapeCode code);
  uint32_t search(ShapeCode code);
  uint32_t add(ShapeCode code, const YarnCellKey& shape);

  const ClothGeometry* geometry_;
  System system_;
  const ShapeTable* known_ = nullptr;
  uint32_t first_ = 0;
  std::vector<YarnCellKey> shapes_;
  std::vector<ShapeCode> codes_;
  bool indexed_ = true;
  int searches_ = 0;
  std::unordered_map<YarnCellKey, uint32_t, YarnCellKeyHash> numbers_;
  std::unordered_map<ShapeCode, uint32_t> numbersOfCodes_;
  std::vector<Recent> recent_ = std::vector<Recent>(size_t{1} << kRecentBits);
};

}  // namespace loomlight
