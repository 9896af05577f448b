#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/field_info.h"

namespace loomlight {

// Threads that do not lie evenly, as a reed with several ends in a dent leaves them. A spacing says of each thread how
// far the next one is from it, in proportion to the others', and repeats (Fabric::warpSpacing); an empty one is even.

/// Most threads before a spacing repeats: with more of them hardly two crossings of a cloth would be alike.
inline constexpr int kMostSpacing = 16;
/// Of each distance.
inline constexpr FieldInfo kSpacingRange{Stage::grid, "", "", "", 0.1, 10};

/// After how many threads it repeats; 1 where it is even.
int spacingRepeat(const std::vector<double>& spacing);

/// How far each thread of the repeat lies beside its place in an even sett of as many threads, in pitches of that,
/// positive towards the next thread: as far to one side at most as to the other. Empty where the spacing is even.
std::vector<double> displacements(const std::vector<double>& spacing);

/// The same spacing as seen from the other side, where the last thread comes first.
std::vector<double> mirroredSpacing(const std::vector<double>& spacing);

/// As a designer writes it: "1 1 2"; "" where it is even.
std::string spacingText(const std::vector<double>& spacing);
/// Of numbers between blanks; even where there is none. Nothing where it is no spacing.
std::optional<std::vector<double>> spacingFromText(const std::string& text);

}  // namespace loomlight
