#include "app/export/file_name.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(FileName, IsOneThatAnySystemTakes) {
  EXPECT_EQ(fileNameOf("Blue twill, 2/2"), "Blue twill, 2-2");
  EXPECT_EQ(fileNameOf("C:\\weven\\\"a\" <b>|*?.dbw"), "C--weven--a- -b----.dbw");
  EXPECT_EQ(fileNameOf(" ..hidden"), "hidden");
  EXPECT_EQ(fileNameOf("two\nlines"), "two-lines");
  EXPECT_EQ(fileNameOf("..."), "Untitled");
  EXPECT_EQ(fileNameOf("Aux.7 wool"), "Aux_.7 wool") << "a device on Windows";
  EXPECT_EQ(fileNameOf("auxiliary"), "auxiliary");
  const std::string umlauts = fileNameOf(std::string(99, 'a') + "\xC3\xBC and more");
  EXPECT_EQ(umlauts, std::string(99, 'a')) << "a letter is whole or not there";
}

TEST(FileName, BothEndingsAreFabrics) {
  for (const char* file : {"denim.json", "denim.loomlight", "a.b/DENIM.Loomlight"})
    EXPECT_TRUE(isFabricFile(file)) << file;
  for (const char* file : {"denim.wif", "denim", "loomlight", "denim.loomlight.png", ".loomlight"})
    EXPECT_FALSE(isFabricFile(file)) << file;
}

TEST(FileName, WeavingFilesHaveSeveralEndings) {
  for (const char* file : {"twill.wif", "TWILL.WIF", "twill.plm", "twill.dtx", "twill.twa", "twill.wif.txt"})
    EXPECT_TRUE(isWeavingFile(file)) << file;
  for (const char* file : {"twill.wpo", "plm", "twill.plm.png", "twill.json"})
    EXPECT_FALSE(isWeavingFile(file)) << file;
}

TEST(FileName, TellsWhoseDraftsAreNotRead) {
  EXPECT_EQ(programOfForeignDraft("tea.towel.WPO"), "WeavePoint");
  for (const char* file : {"twill.wif", "wpo", "twill.wpo.txt"}) EXPECT_EQ(programOfForeignDraft(file), std::nullopt);
}

}  // namespace
}  // namespace loomlight
