#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace loomlight {

/// The components S0, S1 and S2 of which daylight of any temperature is made, at 10 nm from 360 to 780 nm.
inline constexpr int kDaylightStep_nm = 10;
using DaylightTable = std::array<double, 43>;
extern const DaylightTable kDaylightS0, kDaylightS1, kDaylightS2;

/// Relative power of a lamp, at 5 nm from 380 to 780 nm.
inline constexpr int kLampFirst_nm = 380, kLampStep_nm = 5;
struct LampTable {
  const char* name;
  std::array<double, 81> power;
};
std::span<const LampTable> lampTables();

}  // namespace loomlight
