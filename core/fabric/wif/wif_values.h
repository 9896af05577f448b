#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loomlight {

/// How the values of a WIF file are written. All of these take them as programs and people have really written them:
/// blanks around, quotes, a ";" comment behind a number. Nothing where there is no such value.

/// 12, +12, "12", 12.0, 12 ; twelve. Numbers beyond int are none.
std::optional<int> wifWhole(std::string_view value);
/// .212, 0.212, 0,212 (a decimal comma); finite.
std::optional<double> wifDecimal(std::string_view value);
/// true, on, yes, t, y, 1, -1 (as Basic writes it); false, off, no, f, n, 0.
std::optional<bool> wifBoolean(std::string_view value);
/// A text, without the quotes around it.
std::string_view unquoted(std::string_view value);

/// The parts of a list, between commas, or blanks where somebody forgot the commas; none of them empty.
std::vector<std::string_view> wifList(std::string_view value);

/// The numbers of a list of shafts or treadles, however they are parted, and what is to be said of that.
struct WifNumbers {
  std::vector<std::string> parts;
  std::vector<std::string> remarks;  ///< sentences
};
/// 1,2 and 1 2; also 1+2, 1/2, 1&2, 1-2, and 1;2 where nothing but numbers follows.
WifNumbers wifNumbers(std::string_view value);

}  // namespace loomlight
