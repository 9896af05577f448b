#pragma once

#include "core/fabric/model/glossary.h"

namespace loomlight::words {

/// What the page of colours says of an order of yarns.
namespace order {

inline constexpr const char* oneEnd = "{} end \xC2\xB7 {:.1f} mm";
inline constexpr const char* severalEnds = "{} ends \xC2\xB7 {:.1f} mm";
inline constexpr const char* onePick = "{} pick \xC2\xB7 {:.1f} mm";
inline constexpr const char* severalPicks = "{} picks \xC2\xB7 {:.1f} mm";
inline constexpr const char* onlyCounted = "{} threads";  // where they are too many to be written
inline constexpr const char* noSuchYarn = "There is no yarn {} yet.";
inline constexpr const char* yarnBeyondNext = "There is no yarn {}; next is {}.";
inline constexpr Word addYarn{"Add the yarn",
                              "Adds what the order names beyond the yarns that there are, each a copy of the last one"};

}  // namespace order

/// What is said of its stripes.
namespace stripe {

inline constexpr Word of{"Stripes of", "Whose colour order the tools below work on."};

// The table of them
inline constexpr const char *end = "end", *ends = "ends";
inline constexpr const char *pick = "pick", *picks = "picks";
inline constexpr const char* threadsHelp = "Threads of this stripe";
inline constexpr const char* widthHelp = "Width of this stripe in cm, to whole threads";
inline constexpr const char* more = "and {} more";

// By chance
inline constexpr const char* newStripes = "New stripes";
inline constexpr Word length{"Threads", "How many threads the order has until it repeats"};
inline constexpr Word narrowest{"Narrowest stripe", "Threads that a stripe has at least"};
inline constexpr Word widest{"Widest stripe", "Threads that a stripe has at most"};

}  // namespace stripe
}  // namespace loomlight::words
