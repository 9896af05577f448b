#include "core/base/text_encoding.h"

#include <fmt/format.h>
#include <algorithm>

#include <array>
#include <cstdint>

#include "core/base/error.h"

// How it works. A byte order mark says what a text is. Without one, a zero in every other byte means UTF-16; what is
// well-formed is UTF-8 (Unicode, table 3-7: no overlong forms, no surrogates); everything else is taken as
// Windows-1252, in which every byte is a character. Cost: linear in the bytes.

namespace loomlight {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

uint8_t byteAt(std::string_view bytes, size_t i) {
  return static_cast<uint8_t>(bytes[i]);
}

void appendUtf8(std::string& text, char32_t c) {
  const auto push = [&text](char32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) {
    push(c);
  } else if (c < 0x800) {
    push(0xC0 | (c >> 6));
    push(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    push(0xE0 | (c >> 12));
    push(0x80 | ((c >> 6) & 0x3F));
    push(0x80 | (c & 0x3F));
  } else {
    push(0xF0 | (c >> 18));
    push(0x80 | ((c >> 12) & 0x3F));
    push(0x80 | ((c >> 6) & 0x3F));
    push(0x80 | (c & 0x3F));
  }
}

/// Bytes of the UTF-8 sequence at i; 0 where there is none (Unicode, table 3-7: no overlong forms, no surrogates).
size_t sequenceLength(std::string_view bytes, size_t i) {
  const uint8_t first = byteAt(bytes, i);
  if (first < 0x80) return 1;
  const size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                        : first >= 0xE0 && first <= 0xEF ? 3
                        : first >= 0xF0 && first <= 0xF4 ? 4
                                                         : 0;
  if (length == 0 || i + length > bytes.size()) return 0;
  for (size_t k = 1; k < length; ++k)
    if ((byteAt(bytes, i + k) & 0xC0) != 0x80) return 0;
  const uint8_t second = byteAt(bytes, i + 1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

bool isUtf8(std::string_view bytes) {
  for (size_t i = 0; i < bytes.size();) {
    const size_t length = sequenceLength(bytes, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
  const auto unit = [&](size_t i) -> char32_t {
    const char32_t first = byteAt(bytes, i), second = byteAt(bytes, i + 1);
    return bigEndian ? first << 8 | second : second << 8 | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (size_t i = 0; i + 1 < bytes.size(); i += 2) {
    char32_t c = unit(i);
    const bool high = c >= 0xD800 && c < 0xDC00;
    if (high && i + 3 < bytes.size() && (unit(i + 2) & 0xFC00) == 0xDC00) {
      c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    } else if (high || (c >= 0xDC00 && c < 0xE000)) {
      c = kReplacement;
    }
    appendUtf8(text, c);
  }
  if (bytes.size() % 2 != 0) appendUtf8(text, kReplacement);
  return text;
}

std::string fromWindows1252(std::string_view bytes) {
  // 0x80 to 0x9F; the five that are not assigned stay the control characters they are in Latin-1.
  static constexpr std::array<char16_t, 32> kUpper = {0x20AC, 0x0081, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                      0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x008D, 0x017D, 0x008F,
                                                      0x0090, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                      0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x009D, 0x017E, 0x0178};
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (size_t i = 0; i < bytes.size(); ++i) {
    const uint8_t byte = byteAt(bytes, i);
    appendUtf8(text, byte >= 0x80 && byte < 0xA0 ? char32_t{kUpper[byte - 0x80]} : char32_t{byte});
  }
  return text;
}

/// Without a mark: letters of western files have a zero in one half of each UTF-16 unit, and never in the other.
enum class ByteOrder { none, little, big };
ByteOrder guessedByteOrder(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 4096);
  size_t zeros[2] = {0, 0};
  for (size_t i = 0; i < start.size(); ++i)
    if (start[i] == '\0') ++zeros[i % 2];
  const size_t units = start.size() / 2;
  const auto mostly = [units](size_t count) { return units > 1 && count * 4 > units * 3; };
  if (mostly(zeros[1]) && zeros[0] == 0) return ByteOrder::little;
  if (mostly(zeros[0]) && zeros[1] == 0) return ByteOrder::big;
  return ByteOrder::none;
}

}  // namespace

DecodedText decodeText(std::string_view bytes, const std::string& source) {
  DecodedText decoded;
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    decoded = {fromUtf16(bytes.substr(2), bytes[0] == '\xFE'), TextEncoding::utf16};
  } else if (const ByteOrder order = guessedByteOrder(bytes); order != ByteOrder::none) {
    decoded = {fromUtf16(bytes, order == ByteOrder::big), TextEncoding::utf16};
  } else {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    decoded = isUtf8(bytes) ? DecodedText{std::string(bytes), TextEncoding::utf8}
                            : DecodedText{fromWindows1252(bytes), TextEncoding::windows1252};
  }
  // Programs of DOS end a text with Ctrl+Z and fill its last block with zeros.
  constexpr std::string_view kFilling("\x1A\0", 2);
  if (const size_t last = decoded.text.find_last_not_of(kFilling); last != std::string::npos)
    decoded.text.resize(last + 1);
  if (const size_t zero = decoded.text.find('\0'); zero != std::string::npos)
    throw InputError(fmt::format("{}: expected a text, got a zero at character {}: it is binary", source, zero + 1));
  return decoded;
}

std::string_view takeLine(std::string_view& text) {
  const size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  size_t next = end;
  if (next < text.size()) next += text.substr(next).starts_with("\r\n") ? 2 : 1;
  text.remove_prefix(next);
  return line;
}

}  // namespace loomlight
