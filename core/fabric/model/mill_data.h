#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/unknown_keys.h"

namespace loomlight {

/// What a mill writes beside the draft: reed, selvedges, and the setts that it has measured before finishing and after
/// washing. No picture depends on it: that is of the finished cloth, at Fabric::ends_per_cm and picks_per_cm, its ends
/// as far apart as Fabric::warpSpacing has them. A number is 0 where it is not said.
struct MillData {
  static constexpr int kMostInDent = 64, kMostDents = 4096;

  double reed_per_10cm = 0;         ///< dents, 0..1000
  std::vector<int> endsPerDent{2};  ///< of one dent after the other, repeating: 0..kMostInDent each, 0 an empty dent
  double loomEnds_per_cm = 0;       ///< of grey cloth, off the loom and before it is finished, 0..500
  double loomPicks_per_cm = 0;
  double washedEnds_per_cm = 0;  ///< of the finished cloth after it was washed and dried, 0..500
  double washedPicks_per_cm = 0;
  int selvedgeEnds = 0;             ///< of each side, 0..1000
  std::optional<int> selvedgeYarn;  ///< index into Fabric::yarns; where there is none, the warp's order goes on
  int selvedgeEndsPerDent = 2;      ///< 1..kMostInDent
  std::string selvedgeWeave;        ///< as the mill calls it; empty: as the cloth
  UnknownKeys unknown;
  friend bool operator==(const MillData&, const MillData&);
};

}  // namespace loomlight
