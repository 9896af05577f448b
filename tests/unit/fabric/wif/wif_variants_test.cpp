#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "core/fabric/wif/wif_writer.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

/// A strict file taken apart, to be written as another program might.
struct Section {
  std::string name;
  std::vector<std::string> lines;
  bool isNumbered() const {  // lines of numbers: comments may stand behind them
    for (const char* one : {"THREADING", "TIEUP", "TREADLING", "LIFTPLAN", "COLOR TABLE", "WARP COLORS", "WEFT COLORS",
                            "WARP SPACING", "WEFT SPACING", "WARP THICKNESS", "WEFT THICKNESS"})
      if (name == one) return true;
    return false;
  }
  /// Lines of threads, and of treadles.
  bool isOfThreads() const { return isNumbered() && name != "TIEUP" && name != "COLOR TABLE"; }
  bool isFree() const { return name.starts_with("PRIVATE") || name.starts_with("TW"); }
  /// Missing lines of these mean no shaft, no treadle.
  bool meansNoneWhereMissing() const { return name == "THREADING" || name == "TREADLING" || name == "LIFTPLAN"; }
};

std::vector<Section> sectionsOf(const std::string& strict) {
  std::vector<Section> sections;
  for (size_t at = 0; at < strict.size();) {
    const size_t end = strict.find("\r\n", at);
    const std::string line = strict.substr(at, end - at);
    at = end + 2;
    if (line.starts_with('[') && line.ends_with(']'))
      sections.push_back({line.substr(1, line.size() - 2), {}});
    else if (!sections.empty())
      sections.back().lines.push_back(line);
  }
  return sections;
}

template <class Item>
void shuffle(std::vector<Item>& items, Random& random) {
  for (size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(static_cast<uint32_t>(i))]);
}

std::string otherCase(std::string text, uint32_t kind) {
  for (char& c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter < 0x80) c = static_cast<char>(kind == 1 ? std::tolower(letter) : kind == 2 ? std::toupper(letter) : c);
  }
  return text;
}

/// A list of numbers, each one less; where 0 was none there is nothing.
std::string fromZero(const std::string& list) {
  std::string text;
  for (size_t at = 0; at < list.size();) {
    const size_t end = std::min(list.find(',', at), list.size());
    const int number = std::stoi(list.substr(at, end - at));
    if (number > 0) text += fmt::format("{}{}", text.empty() ? "" : ",", number - 1);
    at = end + 1;
  }
  return text;
}

std::string spaced(const std::string& list) {
  std::string text;
  for (const char c : list) text += c == ',' ? std::string(", ") : std::string(1, c);
  return text;
}

/// One file's habits.
struct Habits {
  explicit Habits(Random& random)
      : sectionsInOrder(random.below(2) == 0),
        linesInOrder(random.below(2) == 0),
        letters(random.below(3)),
        blanks(random.below(2) == 0),
        zerosBeforeKeys(random.below(4) == 0),
        comments(random.below(2) == 0),
        leavesOutNone(random.below(2) == 0),
        saysTwice(random.below(4) == 0),
        leavesOutContents(random.below(3) == 0),
        threadsFromZero(random.below(4) == 0),
        treadlesFromZero(random.below(4) == 0),
        lineEnd(random.below(3)),
        encoding(random.below(5)),
        fillsBlock(random.below(4) == 0) {}
  bool sectionsInOrder, linesInOrder;
  uint32_t letters;
  bool blanks, zerosBeforeKeys, comments, leavesOutNone, saysTwice, leavesOutContents;
  bool threadsFromZero, treadlesFromZero;
  uint32_t lineEnd, encoding;
  bool fillsBlock;
};

void writeLine(std::string& text, const Section& section, const std::string& line, const Habits& habits,
               const char* end) {
  const size_t equals = line.find('=');
  if (equals == std::string::npos) {
    text += line + end;
    return;
  }
  std::string key = otherCase(line.substr(0, equals), habits.letters), value = line.substr(equals + 1);
  if (section.isNumbered()) {
    const bool isFirst = key == "1";  // an empty section would say that there is no such plan
    const bool isNone = value.empty() || value == "0";
    const bool fewer =
        (habits.threadsFromZero && section.isOfThreads()) || (habits.treadlesFromZero && section.name == "TIEUP");
    const bool fromZeroOn = habits.threadsFromZero || habits.treadlesFromZero;
    if (fromZeroOn && value == "0") value.clear();  // who counts from 0 cannot write 0 for none
    if (fewer) key = fromZero(key);
    if (habits.treadlesFromZero && section.name == "TREADLING") value = fromZero(value);
    if (habits.leavesOutNone && section.meansNoneWhereMissing() && isNone && !isFirst) return;
    if (habits.saysTwice) text += key + (fromZeroOn ? "=" : "=1") + end;
    if (habits.zerosBeforeKeys) key = fmt::format("00{}", key);
    if (habits.blanks) value = spaced(value);
    if (habits.comments && !value.empty()) value += " ; so it is";
  }
  text += habits.blanks ? fmt::format("  {} = {} ", key, value) : fmt::format("{}={}", key, value);
  text += end;
}

std::string written(std::vector<Section> sections, const Habits& habits, Random& random) {
  constexpr const char* kEnds[] = {"\n", "\r\n", "\r"};
  const char* const end = kEnds[habits.lineEnd];
  if (!habits.sectionsInOrder) shuffle(sections, random);
  std::string text;
  for (Section& section : sections) {
    if (habits.leavesOutContents && section.name == "CONTENTS") continue;
    const bool isFree = section.isFree();
    text += fmt::format("[{}]{}", isFree ? section.name : otherCase(section.name, habits.letters), end);
    if (!habits.linesInOrder && section.isNumbered()) shuffle(section.lines, random);
    for (const std::string& line : section.lines) {
      if (isFree) {
        text += line + end;
        continue;
      }
      if (habits.comments && random.below(5) == 0) text += std::string("; a comment = no value") + end;
      writeLine(text, section, line, habits, end);
    }
    text += end;
  }
  return text;
}

/// Of characters below U+0800, as all of our titles are.
std::u16string utf16Of(const std::string& utf8) {
  std::u16string units;
  for (size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80)
      units += static_cast<char16_t>(byte);
    else
      units += static_cast<char16_t>((byte & 0x1F) << 6 | (static_cast<unsigned char>(utf8[++i]) & 0x3F));
  }
  return units;
}

std::string encoded(const std::string& utf8, uint32_t encoding) {
  if (encoding == 0) return utf8;
  if (encoding == 1) return "\xEF\xBB\xBF" + utf8;
  std::string bytes;
  if (encoding == 2) {  // Latin-1
    for (const char16_t unit : utf16Of(utf8)) bytes += static_cast<char>(unit);
    return bytes;
  }
  const bool bigEndian = encoding == 3;
  for (const char16_t unit : u'\uFEFF' + utf16Of(utf8)) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    bytes += bigEndian ? high : low;
    bytes += bigEndian ? low : high;
  }
  return bytes;
}

TEST(WifVariants, ADraftIsTheSameHoweverItIsWritten) {
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const std::string strict = wifFromDocument(randomDocument(random));
    const Habits habits(random);
    std::string bytes = encoded(written(sectionsOf(strict), habits, random), habits.encoding);
    if (habits.fillsBlock && habits.encoding < 3) bytes += std::string("\x1A\0\0\0\0", 5);
    WifDocument expected = document(strict), read = document(bytes);
    read.named = {};             // lines that say nothing may be left out
    expected.rest.kept.clear();  // its comments and letters are those of the file
    read.rest.kept.clear();
    ASSERT_EQ(read, expected) << "file " << i << ":\n" << bytes;
  }
}

}  // namespace
}  // namespace loomlight
