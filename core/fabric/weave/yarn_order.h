#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loomlight {

/// The order of yarns along a warp or weft as weavers write it: "4A 2B" is four ends (or picks) of the first yarn, then
/// two of the second, repeating; "3(4A 2B)" is that three times.
std::string yarnOrderText(const std::vector<int>& sequence);

/// Reads it back; groups may repeat: "3(4A 2B) 10C". Throws InputError with what was expected when the text is no such
/// order, names a yarn beyond `yarnCount`, or asks for more than `most`.
std::vector<int> yarnOrderFromText(std::string_view text, int yarnCount, int most);

}  // namespace loomlight
