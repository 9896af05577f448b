#include "core/fabric/wif/wif_writer.h"
#include "core/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/fabric/wif/wif_values.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

TEST(WifWriter, WhatIsWrittenIsReadAgainWithoutAWarning) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const WifDocument written = randomDocument(random);
    const std::string text = wifFromDocument(written);
    WifWarnings warnings;
    WifDocument read = readWif(text, "x.wif", warnings);
    EXPECT_EQ(read.program, "Loomlight " LOOMLIGHT_VERSION);
    read.program.clear();
    EXPECT_EQ(read, written) << text;
    std::vector<std::string> said = inLines(warnings.list());
    // Two plans that differ, and threads without sizes, are the document's own fault.
    std::erase_if(said, [](const std::string& s) { return s.find("weaves another cloth") != std::string::npos; });
    std::erase_if(said, [](const std::string& s) { return s.find("No shaft is tied") != std::string::npos; });
    std::erase_if(said, [](const std::string& s) { return s.find("are named") != std::string::npos; });
    std::erase_if(said, [](const std::string& s) { return s.find("none is said") != std::string::npos; });
    EXPECT_THAT(said, testing::IsEmpty()) << text;
    if (HasFailure()) return;
  }
}

TEST(WifWriter, PrivateSectionsOfAnyNameComeBack) {
  WifDocument d = document(twillFile() + "\n[a=b]\nx=1\n\n[[odd]\ny=2\n\n[;z]\nw=3\n");
  d.program.clear();
  WifWarnings warnings;
  WifDocument read = readWif(wifFromDocument(d), "x.wif", warnings);
  read.program.clear();
  EXPECT_EQ(read, d);
  EXPECT_EQ(wifFromDocument(read), wifFromDocument(d));
}

TEST(WifWriter, IsStrict) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const WifDocument d = randomDocument(random);
    const std::string text = wifFromDocument(d);
    EXPECT_EQ(text.rfind("[WIF]\r\nVersion=1.1\r\nDate=April 20, 1997\r\nDevelopers=wif@mhsoft.com\r\n"
                         "Source Program=Loomlight\r\n",
                         0),
              0u);
    for (size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
      EXPECT_EQ(text[at - 1], '\r');
    WifWarnings warnings;
    const WifSections sections = parseWifSections(text, "x", warnings);
    const auto listed = [&](const std::string& name) {
      const WifEntry* const entry = sections.find("CONTENTS")->find(lowerCase(name));
      return entry && entry->value == "true";
    };
    for (const WifSection& section : sections.sections)
      EXPECT_EQ(listed(section.name), section.name != "WIF" && section.name != "CONTENTS") << section.name;
    const auto lines = [&](const char* name) { return sections.find(name) ? sections.find(name)->entries.size() : 0; };
    EXPECT_EQ(lines("THREADING"), d.draft.threading.size()) << "every end has a line";
    EXPECT_EQ(lines("TREADLING"), d.draft.treadling.size());
    EXPECT_EQ(lines("LIFTPLAN"), d.draft.liftplan.size());
    EXPECT_EQ(lines("TIEUP"), d.draft.tieUp.size());
    for (const char* required : {"WEAVING", "WARP", "WEFT"}) EXPECT_GE(lines(required), 1u);
  }
}

TEST(WifWriter, RestGoesThroughItsLines) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const WifRest rest = randomDocument(random).rest;
    std::string text;
    for (const std::string& line : wifRestLines(rest)) text += line + "\n";
    WifWarnings warnings;
    EXPECT_EQ(readWifRest(parseWifSections(text, "x", warnings), {}, warnings), rest) << text;
    EXPECT_THAT(warnings.list(), testing::IsEmpty());
  }
}

TEST(WifWriter, TextsCannotBreakTheFile) {
  WifDocument d = document(twillFile());
  d.title = "x\r\n[WEAVING]\r\nShafts=1";
  d.notes = {"a\n[WARP]\nThreads=1"};
  const WifDocument read = document(wifFromDocument(d));
  EXPECT_EQ(read.draft, d.draft);
  EXPECT_EQ(read.title, "x  [WEAVING]  Shafts=1");
}

}  // namespace
}  // namespace loomlight
