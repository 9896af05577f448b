#pragma once

#include <string_view>

namespace loomlight {

/// As much of a UTF-8 text from its beginning as fits into so many bytes in whole characters.
inline std::string_view wholeCharacters(std::string_view text, size_t mostBytes) {
  if (text.size() <= mostBytes) return text;
  const auto continuesCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  while (mostBytes > 0 && continuesCharacter(text[mostBytes])) --mostBytes;
  return text.substr(0, mostBytes);
}

}  // namespace loomlight
