#pragma once

#include <cstdint>
#include <vector>

#include "render/bvdf/bvdf.h"

namespace loomlight {

/// The tables of a fabric: one for each kind of yarn, that is for yarns of equal fibres, whatever their colour.
struct BvdfSet {
  std::vector<Bvdf> tables;
  uint64_t rays = 0;             ///< shadow rays they were made of
  std::vector<int> tableOfYarn;  ///< per Fabric::yarns

  const Bvdf& of(int yarn) const { return tables[tableOfYarn[yarn]]; }
  size_t bytes() const {
    size_t sum = 0;
    for (const Bvdf& table : tables) sum += table.ratios().size_bytes();
    return sum;
  }
};

}  // namespace loomlight
