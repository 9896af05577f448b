#pragma once

#include "core/fabric/model/glossary.h"

/// In what the trade counts, twists and measures.
namespace loomlight::words::trade {

inline constexpr Word countedIn{"Counted in",
                                "The system of the trade in which the count is shown. Typed counts may be in any of "
                                "them."};
inline constexpr const char* countSystems[] = {"tex (g per km)", "dtex (g per 10 km)", "den (g per 9 km)",
                                               "Nm (km per kg)", "Ne (cotton count)",  "NeK (worsted count)",
                                               "NeL (linen lea)"};

inline constexpr Word twistIn{"Twist in",
                              "Turns on a metre, or the twist multiplier TM: turns per inch over the square root of "
                              "the cotton count. Warp yarns have 3.8 to 4.5, soft knitting yarns 3.2 to 3.8."};
inline constexpr const char* twistUnits[] = {"turns/m", "TM"};

inline constexpr Word lengthsIn{"Lengths in", "Of rulers, setts and repeats."};
inline constexpr const char* lengthUnits[] = {"cm", "inch"};

inline constexpr Word pieceLength{"Length", "Of the piece, along the warp"};
inline constexpr Word pieceWidth{"Width", "Of the piece, along the weft"};

}  // namespace loomlight::words::trade
