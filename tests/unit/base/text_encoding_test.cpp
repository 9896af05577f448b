#include "core/base/text_encoding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

std::string utf16(const std::u16string& text, bool bigEndian, bool mark) {
  std::string bytes;
  const auto put = [&](char16_t c) {
    const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 0xFF);
    bytes += bigEndian ? high : low;
    bytes += bigEndian ? low : high;
  };
  if (mark) put(0xFEFF);
  for (const char16_t c : text) put(c);
  return bytes;
}

TEST(TextEncoding, Utf8IsTakenAsItIsWithoutItsMark) {
  EXPECT_EQ(decodeText("Tücher 織", "x").text, "Tücher 織");
  EXPECT_EQ(decodeText("\xEF\xBB\xBF[WIF]", "x").text, "[WIF]");
  EXPECT_EQ(decodeText("", "x").text, "");
}

TEST(TextEncoding, Utf16OfBothByteOrdersWithAndWithoutAMark) {
  for (const bool big : {false, true})
    for (const bool mark : {false, true}) {
      const DecodedText decoded = decodeText(utf16(u"[WIF]\r\nTitle=für 織 \U0001F9F6", big, mark), "x");
      EXPECT_EQ(decoded.text, "[WIF]\r\nTitle=für 織 \U0001F9F6") << big << mark;
      EXPECT_EQ(decoded.encoding, TextEncoding::utf16);
    }
}

TEST(TextEncoding, BrokenUtf16BecomesReplacementCharacters) {
  EXPECT_EQ(decodeText(utf16({u'a', 0xD83E, u'b', 0xDDF6}, false, true), "x").text, "a\uFFFDb\uFFFD");
  EXPECT_EQ(decodeText(utf16(u"ab", true, true) + "c", "x").text, "ab\uFFFD");
}

TEST(TextEncoding, WhatIsNoUtf8IsWindows1252) {
  const DecodedText decoded = decodeText(
      "T\xFC"
      "cher \x80 \x93quoted\x94",
      "x");
  EXPECT_EQ(decoded.text, "Tücher € “quoted”");
  EXPECT_EQ(decoded.encoding, TextEncoding::windows1252);
  for (const char* wrong : {"\xC0\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\x80", "\xE0\x80\x80"})
    EXPECT_EQ(decodeText(wrong, "x").encoding, TextEncoding::windows1252);
}

TEST(TextEncoding, TheFillingAfterATextIsLeftOut) {
  EXPECT_EQ(decodeText(std::string("1=2\r\n\x1A\0\0\0", 9), "x").text, "1=2\r\n");
  EXPECT_EQ(decodeText("1=2\x1A", "x").text, "1=2");
}

TEST(TextEncoding, BinaryIsRefusedByName) {
  try {
    decodeText(std::string("[WIF]\0\x01", 7), "x.wif");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("x.wif: expected a text, got a zero at character 6"));
  }
  EXPECT_THROW(decodeText(std::string(1000, '\0'), "x"), InputError);
}

}  // namespace
}  // namespace loomlight
