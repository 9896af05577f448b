#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

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
  EXPECT_THAT(complaint("400,0.1\n700,0.2\n"), HasSubstr("1 to 20 nm apart"));
  // Micrometres are a wrong unit.
  EXPECT_THAT(complaint("0.40,0.1\n0.41,0.1\n0.70,0.2\n"), HasSubstr("0.4 to 0.7 nm"));
}

/// In steps of 10 nm, or another, without those that are left out.
std::string tableWithout(std::vector<int> leftOut, int step_nm = 10) {
  std::string text;
  for (int nm = 400; nm <= 700; nm += step_nm)
    if (std::find(leftOut.begin(), leftOut.end(), nm) == leftOut.end()) text += fmt::format("{},0.2\n", nm);
  return text;
}

TEST(MistakenSwatch, WithAGapSaysWhichWavelengthIsMissing) {
  EXPECT_EQ(swatchesFrom(tableWithout({}), "a.csv").swatches.size(), 1u);
  EXPECT_THAT(complaint(tableWithout({550})), AllOf(HasSubstr("10 nm as most are"), HasSubstr("550 nm is missing")));
  EXPECT_THAT(complaint(tableWithout({410})), HasSubstr("410 nm is missing"));
  EXPECT_THAT(complaint(tableWithout({690})), HasSubstr("690 nm is missing"));
  EXPECT_THAT(complaint(tableWithout({550, 560, 570})), HasSubstr("550 to 570 nm are missing"));
  EXPECT_THAT(complaint(tableWithout({500, 600}, 20)), AllOf(HasSubstr("20 nm as"), HasSubstr("500 nm is missing")));
  EXPECT_THAT(complaint(with(tableWithout({}), "550,", "553,")), HasSubstr("553 nm does not fit behind 540 nm"));
  EXPECT_THAT(complaint(with(tableWithout({}), "550,", "540,")), HasSubstr("540 nm does not fit behind 540 nm"));
}

/// From .95 to 1.6: a deep black in percent, or what a brightener does to a white.
std::string betweenUnits(const std::string& title) {
  std::string text = title;
  for (int nm = 400; nm <= 700; nm += 10) text += fmt::format("{},{}\n", nm, nm < 640 ? 0.95 : 1.6);
  return text;
}

TEST(MistakenSwatch, WithoutAUnitIsNotGuessedWhereItMayBeEither) {
  EXPECT_THAT(complaint(betweenUnits("")), AllOf(HasSubstr("says its unit"), HasSubstr("\"nm (fraction)\"")));
  const auto first = [](const std::string& text) { return swatchesFrom(text, "lot.txt").swatches[0].values[0]; };
  EXPECT_NEAR(first(betweenUnits("nm (%),black\n")), 0.0095, 1e-12);
  EXPECT_NEAR(first(betweenUnits("nm (fraction),white\n")), 0.95, 1e-12);
  const auto cgats = [](const std::string& said) {
    return with(with(cgatsText(), "0.3500", "1.6"), "NUMBER_OF_SETS", said + "\nNUMBER_OF_SETS");
  };
  EXPECT_THAT(complaint(cgats("")), HasSubstr("SPECTRAL_NORM"));
  EXPECT_NEAR(first(cgats("SPECTRAL_NORM \"100.0\"")), 0.0005, 1e-12);
  EXPECT_NEAR(first(cgats("SPECTRAL_NORM \"1\"")), 0.05, 1e-12);
  EXPECT_THAT(complaint(cgats("SPECTRAL_NORM \"7\"")), HasSubstr("SPECTRAL_NORM: expected 100"));
  // CxF is of fractions, and says so by being CxF.
  EXPECT_NEAR(first(with(cxfText(), "0.3500", "1.1")), 0.05, 1e-12);
  EXPECT_THAT(complaint(with(betweenUnits("nm (fraction),a\n"), "400,0.95", "400,12")), HasSubstr("400 nm"));
}

TEST(MistakenSwatch, OfKubelkaAndMunkIsNoReflectance) {
  std::string rows;
  for (int nm = 400; nm <= 700; nm += 10) rows += fmt::format("{},{}\n", nm, 12.5 - 0.02 * (nm - 400));
  EXPECT_EQ(swatchesFrom("nm,R\n" + rows, "a.csv").swatches.size(), 1u);
  EXPECT_THAT(complaint("nm,K/S\n" + rows), HasSubstr("K/S"));
  EXPECT_THAT(complaint("# k/s of the lot\n" + rows), HasSubstr("K/S"));
  EXPECT_THAT(complaint(with(cgatsText(), "ORIGINATOR", "DESCRIPTOR \"K/S values\"\nORIGINATOR")), HasSubstr("K/S"));
  EXPECT_THAT(complaint(with(qtxText(), "VIEWING=%R", "VIEWING=K/S")), HasSubstr("K/S"));
}

TEST(MistakenSwatch, WithImpossibleValuesSaysWhere) {
  EXPECT_THAT(complaint(with(csvOfRows(), "15,00", "1500,0")),
              AllOf(HasSubstr("column 2"), HasSubstr("at 500 nm it is 1500 %")));
  EXPECT_THAT(complaint(with(csvOfRows(), "15,00", "-15,0")), HasSubstr("500 nm"));
  EXPECT_THAT(complaint(with(csvOfRows(), "15,00", "nan")), AllOf(HasSubstr("line 12"), HasSubstr("column 2")));
  EXPECT_THAT(complaint(with(csvOfColumns(), "0.1500", "inf")), AllOf(HasSubstr("line 2"), HasSubstr("500 nm")));
  EXPECT_THAT(complaint(with(cgatsText(), "0.1500", "0.15x")),
              AllOf(HasSubstr("line 11"), HasSubstr("SPECTRAL_NM500")));
  EXPECT_THAT(complaint(with(cxfText(), "0.1500", "?")),
              AllOf(HasSubstr("navy wool"), HasSubstr("expected numbers"), HasSubstr("number 11 is \"?\"")));
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
  // Each of the spectra has the name of its object.
  std::string spectra;
  for (int i = 0; i < 25'000; ++i) spectra += "<ReflectanceSpectrum/>";
  EXPECT_THAT(complaint("<CxF><Object Name=\"" + std::string(4'000'000, 'n') + "\">" + spectra + "</Object></CxF>"),
              HasSubstr("at most 20000"));
  const std::string third(3'000'000, '1');
  EXPECT_THROW(swatchesFrom(third + third + third, "a.csv"), InputError);
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
  int read = 0, refused = 0;
  for (const std::string& whole : {cgatsText(), qtxText(), cxfText(), csvOfColumns(), csvOfRows()})
    for (int i = 0; i < 150; ++i) {
      const std::string text = mutated(whole, random);
      try {
        for (const MeasuredSwatch& swatch : swatchesFrom(text, "a").swatches)
          for (const float value : bandReflectance(swatch)) EXPECT_TRUE(value >= 0 && value <= 1);
        ++read;
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace loomlight
