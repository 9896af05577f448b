#pragma once

#include "core/fabric/model/glossary.h"

namespace loomlight::words {

/// What the page of the cloth says.
namespace clothPage {

inline constexpr const char* sett = "Sett";
inline constexpr Word perCm{"Per cm", "Ends and picks on one centimetre"};
inline constexpr Word perInch{"Per inch", "Ends and picks on one inch"};
inline constexpr const char* even = "even";
inline constexpr const char* spacingExpected = "Expected at most {} numbers from {:g} to {:g} between blanks: 1 2";
inline constexpr const char* finish = "Finish";

// What follows for it
inline constexpr const char* thisCloth = "This cloth";
inline constexpr Word warpCrimp{"Warp crimp", "How much longer the warp yarn is than the cloth it lies in"};
inline constexpr Word weftCrimp{"Weft crimp", "How much longer the weft yarn is than the cloth it lies in"};
inline constexpr Word warpCount{"Warp count", "Mean count of the warp yarns"};
inline constexpr Word weftCount{"Weft count", "Mean count of the weft yarns"};

inline constexpr const char* binding = "Binding";
inline constexpr const char* unbound = "{} unbound";
inline constexpr Word warpOnFace{"Warp on the face",
                                 "Share of the crossings with the warp on top: at 50 % face and back are alike"};
inline constexpr Word interlacings{"Interlacings", "Changes of side in one repeat, of all its ends and picks"};

// The yarn that a piece takes
inline constexpr const char* yarnForPiece = "Yarn for a piece";
inline constexpr const char* needHelp = "{}: warp {}, weft {}. Loom waste and shrinkage are not counted.";

inline constexpr const char* remarks = "Remarks";
inline constexpr const char* noRemarks = "Nothing that a weaver would object to.";

}  // namespace clothPage

/// What is said of reed, selvedges and the states of the cloth.
namespace mill {

inline constexpr const char* reedAndSelvedges = "Reed and selvedges";
inline constexpr const char* dentsPerInch = "dents/in";
inline constexpr const char* dentingExpected = "Expected ends of one dent after the other, 0 to {}: 2, or 3 3 0";
inline constexpr const char* asWarp = "As the warp";
inline constexpr const char* asCloth = "as the cloth";
inline constexpr Word selvedgeYarn{words::selvedgeYarn.label, "What the selvedges are warped with."};

inline constexpr const char* setts = "Sett from reed to wash";
inline constexpr const char* ends = "ends";
inline constexpr const char* picks = "picks";
inline constexpr Word contraction{"Shrinks from reed",
                                  "By how much the finished cloth is narrower, and shorter, than it lay in the reed."};
inline constexpr Word washingShrinkage{"Shrinks in wash",
                                       "By how much the washed cloth is narrower, and shorter, than the finished "
                                       "one."};

}  // namespace mill
}  // namespace loomlight::words
