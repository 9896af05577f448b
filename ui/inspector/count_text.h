#pragma once

#include <optional>
#include <string_view>

#include "core/fabric/model/yarn_count.h"

namespace loomlight {

/// A yarn's count as it was written.
struct CountEntry {
  double tex = 0;
  bool ofSingles = false;        ///< tex is that of each single, not of the whole yarn
  std::optional<int> plies;      ///< where the text says how many
  std::optional<int> cords;      ///< says it too, then: 1 where it is no cable
  std::optional<int> filaments;  ///< of a single, where the text says how many; without plies it is of one single
};

/// The count of a yarn as spinners write it: "19.7 tex", "150 den", "167 dtex f48" (of 48 filaments; "150D/48F" too),
/// "20/22 den" (raw silk, between these), "30 Ne", "30s", "Nm 60", and of plied ones "30/2 Ne" and "2/60 Nm" (singles
/// and plies, the larger number being the singles), "20 tex x 2" (as many of these) or "R 40 tex/2" (what they make
/// together). A cable has a number more: "20/2/3 Ne" is three cords of two plies, so are "30 tex x 2 x 3" and "R 180
/// tex/2/3". An indirect count is one of singles, also where their number is not said; a direct one is that of the
/// yarn. Without a unit it is meant in `usual`. nullopt when it is none of these.
std::optional<CountEntry> countFromText(std::string_view text, CountSystem usual);

/// How fine a fibre of that density is, in dtex: "1.7 dtex", "1.5 den", or as wool is sold by its thickness, "18.5
/// mic". nullopt when it is none of these.
std::optional<double> finenessFromText(std::string_view text, double density_g_cm3);

/// Turns of a yarn of `tex`, per metre: "780 t/m", "20 tpi", or a twist multiplier "4.2 TM". nullopt when it is none of
/// these.
std::optional<double> twistFromText(std::string_view text, double tex);

}  // namespace loomlight
