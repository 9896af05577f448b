#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/fabric/swatch/measured_swatch.h"
#include "tests/support/mutated.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/fabric/swatch/swatch_texts.h"

namespace loomlight {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using namespace test;

std::string complaint(const std::string& text) {
  return messageOf<InputError>([&] { swatchesFrom(text, "lot.txt"); });
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

TEST(MistakenSwatch, OfNoKindAtAllIsRefused) {
  EXPECT_THAT(complaint(""), HasSubstr("lot.txt"));
  EXPECT_THAT(complaint("dear diary\n"), HasSubstr("expected reflectances"));
  EXPECT_THAT(complaint(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)), HasSubstr("lot.txt"));
  EXPECT_THAT(complaint("<svg/>"), HasSubstr("expected CxF"));
  EXPECT_THAT(complaint("<a><b>"), HasSubstr("expected XML"));
}

TEST(MistakenSwatch, WithMissingBandsSaysWhatIsThere) {
  std::string text;
  for (int nm = 450; nm <= 650; nm += 10) text += fmt::format("{},0.2\n", nm);
  EXPECT_THAT(complaint(text), HasSubstr("there is 450 to 650 nm"));
  EXPECT_THAT(complaint(with(csvOfRows(), "500;15,00;30,00\n", "")), HasSubstr("equal steps"));
  EXPECT_THAT(complaint("400,0.1\n700,0.2\n"), HasSubstr("1 to 20 nm apart"));
  // Micrometres are a wrong unit.
  EXPECT_THAT(complaint("0.40,0.1\n0.41,0.1\n0.70,0.2\n"), HasSubstr("0.4 to 0.7 nm"));
}

TEST(MistakenSwatch, WithImpossibleValuesSaysWhere) {
  EXPECT_THAT(complaint(with(csvOfRows(), "15,00", "1500,0")),
              AllOf(HasSubstr("column 2"), HasSubstr("at 500 nm it is 1500 %")));
  EXPECT_THAT(complaint(with(csvOfRows(), "15,00", "-15,0")), HasSubstr("500 nm"));
  EXPECT_THAT(complaint(with(csvOfRows(), "15,00", "nan")), AllOf(HasSubstr("line 12"), HasSubstr("column 2")));
  EXPECT_THAT(complaint(with(csvOfColumns(), "0.1500", "inf")), AllOf(HasSubstr("line 2"), HasSubstr("500 nm")));
  EXPECT_THAT(complaint(with(cgatsText(), "0.1500", "0.15x")),
              AllOf(HasSubstr("line 11"), HasSubstr("SPECTRAL_NM500")));
  EXPECT_THAT(complaint(with(cxfText(), "0.1500", "?")), HasSubstr("navy wool"));
  EXPECT_THAT(complaint(with(qtxText(), "15.0000", "1e400")), HasSubstr("line 7"));
}

TEST(MistakenSwatch, ThatIsCutOffSaysSo) {
  EXPECT_THAT(complaint(with(cgatsText(), "END_DATA\n", "")), HasSubstr("END_DATA"));
  EXPECT_THAT(complaint(cgatsText().substr(0, 300)), HasSubstr("before the file ends"));
  EXPECT_THAT(complaint(with(cgatsText(), "ecru ", "")), HasSubstr("the last has 32"));
  EXPECT_THAT(complaint(with(qtxText(), "15.0000,", "")), AllOf(HasSubstr("31"), HasSubstr("there are 30")));
  EXPECT_THAT(complaint(with(csvOfColumns(), ",0.3500\n", "\n")), HasSubstr("700 nm"));
  EXPECT_THAT(complaint(cxfText().substr(0, 500)), HasSubstr("expected XML"));
}

/// None of these may take long, or much.
TEST(MistakenSwatch, ThatIsMadeToHurtIsRefused) {
  std::string deep;
  for (int i = 0; i < 50'000; ++i) deep += "<Object>";
  EXPECT_THROW(swatchesFrom("<CxF>" + deep, "a.cxf"), InputError);
  for (int i = 0; i < 50'000; ++i) deep += "</Object>";
  EXPECT_THAT(complaint("<CxF>" + deep + "</CxF>"), HasSubstr("deep"));
  EXPECT_THAT(complaint("<CxF>" +
                        [] {
                          std::string many;
                          for (int i = 0; i < 50'000; ++i) many += "<Object/>";
                          return many;
                        }() +
                        "</CxF>"),
              HasSubstr("there are none"));
  EXPECT_THROW(swatchesFrom(std::string(9'000'000, '1'), "a.csv"), InputError);
  EXPECT_THROW(swatchesFrom(std::string(1'000'000, ','), "a.csv"), InputError);
  EXPECT_THROW(swatchesFrom("BEGIN_DATA_FORMAT " + std::string(1'000'000, 'a') + " b c", "a.txt"), InputError);
  EXPECT_THROW(swatchesFrom("CGATS\nNUMBER_OF_SETS 99999999\n.INCLUDE \"/dev/zero\"\nBEGIN_DATA_FORMAT\n", "a.txt"),
               InputError);
  EXPECT_THROW(swatchesFrom("<!DOCTYPE CxF [<!ENTITY a SYSTEM \"/etc/hostname\">]><CxF>&a;</CxF>", "a.cxf"),
               InputError);
}

/// Damaged anywhere, a file is read or refused.
TEST(MistakenSwatch, OfAnyDamageIsReadOrRefused) {
  Random random(18);
  for (const std::string& whole : {cgatsText(), qtxText(), cxfText(), csvOfColumns(), csvOfRows()})
    for (int i = 0; i < 150; ++i) {
      const std::string text = mutated(whole, random);
      try {
        for (const MeasuredSwatch& swatch : swatchesFrom(text, "a").swatches)
          for (const float value : bandReflectance(swatch)) EXPECT_TRUE(value >= 0 && value <= 1);
      } catch (const InputError&) {
      }
    }
}

}  // namespace
}  // namespace loomlight
