#include "core/fabric/swatch/measured_swatch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/fabric/swatch/swatch_texts.h"

namespace loomlight {
namespace {

using testing::HasSubstr;
using namespace test;

void expectFirstIsNavy(const SwatchFile& file, SpecularComponent specular) {
  const MeasuredSwatch& navy = file.swatches.front();
  EXPECT_EQ(navy.first_nm, 400);
  EXPECT_NEAR(navy.step_nm, 10, 1e-12);
  EXPECT_EQ(navy.last_nm(), 700);
  ASSERT_EQ(navy.values.size(), 31u);
  for (int i = 0; i < 31; ++i) EXPECT_NEAR(navy.values[static_cast<size_t>(i)], swatchValue(i), 1e-4) << i;
  EXPECT_EQ(navy.specular, specular);
}

TEST(MeasuredSwatch, IsReadFromCgats) {
  const SwatchFile file = swatchesFrom(cgatsText(), "a.txt");
  ASSERT_EQ(file.swatches.size(), 2u);
  expectFirstIsNavy(file, SpecularComponent::excluded);
  EXPECT_EQ(file.swatches[0].name, "navy wool");
  EXPECT_EQ(file.swatches[1].name, "ecru");
  EXPECT_NEAR(file.swatches[1].values[0], 0.1, 1e-9);
}

TEST(MeasuredSwatch, IsReadFromQtx) {
  const SwatchFile file = swatchesFrom(qtxText(), "a.qtx");
  ASSERT_EQ(file.swatches.size(), 2u);
  expectFirstIsNavy(file, SpecularComponent::included);
  EXPECT_EQ(file.swatches[1].name, "lot 7");
  EXPECT_NEAR(file.swatches[1].values[0], 0.045, 1e-9);
}

TEST(MeasuredSwatch, IsReadFromCxf) {
  const SwatchFile file = swatchesFrom(cxfText(), "a.cxf");
  ASSERT_EQ(file.swatches.size(), 1u);
  expectFirstIsNavy(file, SpecularComponent::included);
}

TEST(MeasuredSwatch, IsReadFromTablesOfEitherDirection) {
  const SwatchFile columns = swatchesFrom(csvOfColumns(), "a.csv");
  ASSERT_EQ(columns.swatches.size(), 2u);
  expectFirstIsNavy(columns, SpecularComponent::unknown);
  EXPECT_EQ(columns.swatches[1].name, "ecru");
  const SwatchFile rows = swatchesFrom(csvOfRows(), "a.csv");
  ASSERT_EQ(rows.swatches.size(), 2u);
  expectFirstIsNavy(rows, SpecularComponent::excluded);
  EXPECT_EQ(rows.swatches[1].name, "ecru");
}

TEST(MeasuredSwatch, WithoutANameIsCalledAsItsFile) {
  std::string text;
  for (int nm = 400; nm <= 700; nm += 20) text += fmt::format("{},0.2\n", nm);
  EXPECT_EQ(swatchesFrom(text, "swatches/lot 7.csv").swatches[0].name, "lot 7");
}

/// What is guessed is said, and what is said in the file is not guessed.
TEST(MeasuredSwatch, SaysWhichUnitItGuessed) {
  const auto unitRemark = [](const SwatchFile& file) {
    for (const std::string& remark : file.remarks)
      if (remark.find("unit") != std::string::npos) return remark;
    return std::string();
  };
  EXPECT_THAT(unitRemark(swatchesFrom(csvOfRows(), "a.csv")), HasSubstr("percent"));
  EXPECT_THAT(unitRemark(swatchesFrom(csvOfColumns(), "a.csv")), HasSubstr("fractions"));
  EXPECT_EQ(unitRemark(swatchesFrom(qtxText(), "a.qtx")), "");
  std::string named = csvOfRows();
  named.replace(0, 2, "nm %R");
  EXPECT_EQ(unitRemark(swatchesFrom(named, "a.csv")), "");
}

/// A black of 1.2 to 1.9 % has no value above 2 either.
TEST(MeasuredSwatch, OfABlackInPercentIsNoMirror) {
  std::string text;
  for (int nm = 400; nm <= 700; nm += 10) text += fmt::format("{},{}\n", nm, 1.2 + 0.001 * (nm - 400));
  EXPECT_NEAR(swatchesFrom(text, "a.csv").swatches[0].values[0], 0.012, 1e-9);
}

TEST(MeasuredSwatch, SaysWhereAFileMixesWaysToMeasure) {
  const auto mixed = HasSubstr("Only two that agree");
  std::string text = csvOfRows();
  EXPECT_THAT(swatchesFrom(text, "a.csv").remarks, testing::Not(testing::Contains(mixed)));
  text.replace(text.find("ecru"), 4, "ecru (SCI)");
  const SwatchFile file = swatchesFrom(text, "a.csv");
  EXPECT_THAT(file.remarks, testing::Contains(mixed));
  EXPECT_EQ(file.swatches[0].specular, SpecularComponent::excluded);
  EXPECT_EQ(file.swatches[1].specular, SpecularComponent::included);
  // Of two tables of CGATS each says its own.
  std::string other = cgatsText();
  other.replace(other.find("excluded"), 8, "included");
  const SwatchFile both = swatchesFrom(cgatsText() + other, "a.txt");
  EXPECT_EQ(both.swatches[0].specular, SpecularComponent::excluded);
  EXPECT_EQ(both.swatches[3].specular, SpecularComponent::included);
  EXPECT_THAT(both.remarks, testing::Contains(mixed));
}

TEST(MeasuredSwatch, SaysThatBrightenersAreNotModelled) {
  std::string text;
  for (int nm = 400; nm <= 700; nm += 10) text += fmt::format("{},{}\n", nm, nm == 440 ? 119.3 : 88.0);
  const SwatchFile file = swatchesFrom(text, "white.csv");
  EXPECT_THAT(file.remarks, testing::Contains(HasSubstr("\"white\" reflects more than 100 %")));
  EXPECT_NEAR(file.swatches[0].values[4], 1.193, 1e-9);
  for (const float value : bandReflectance(file.swatches[0])) EXPECT_LE(value, 1);
  EXPECT_THAT(swatchesFrom(csvOfRows(), "a.csv").remarks, testing::Not(testing::Contains(HasSubstr("brightener"))));
}

MeasuredSwatch sampled(double first_nm, double step_nm, double last_nm, double (*curve)(double)) {
  MeasuredSwatch swatch{"curve", first_nm, step_nm, {}, {}};
  for (double nm = first_nm; nm <= last_nm + 1e-9; nm += step_nm) swatch.values.push_back(curve(nm));
  return swatch;
}

/// As dyes are: smooth over some 60 nm. Steps of 20 nm leave an error of the sixth power of 20 over that.
TEST(BandReflectance, OfOtherStepsIsThatOfTenNanometres) {
  const auto dye = [](double nm) { return 0.1 + 0.7 / (1 + std::exp((560 - nm) / 25)); };
  for (const double step : {5.0, 10.0, 20.0}) {
    const Spectrum bands = bandReflectance(sampled(360, step, 740, dye));
    for (size_t j = 0; j < kBands; ++j)
      EXPECT_NEAR(bands[j], dye(bandWavelength_nm(j)), step > 10 ? 2e-3 : 1e-6) << step << " " << j;
  }
}

TEST(BandReflectance, HoldsTheEndsThatWereNotMeasured) {
  const auto slope = [](double nm) { return nm / 1000; };
  const Spectrum bands = bandReflectance(sampled(400, 10, 700, slope));
  EXPECT_NEAR(bands[0], 0.4, 1e-6);
  EXPECT_NEAR(bands[1], 0.4, 1e-6);
  EXPECT_NEAR(bands[3], 0.41, 1e-6);
  EXPECT_NEAR(bands[kBands - 1], 0.7, 1e-6);
  const SwatchFile file = swatchesFrom(cxfText(), "a.cxf");
  EXPECT_THAT(file.remarks, testing::Contains(HasSubstr("measured from 400 to 700 nm")));
}

TEST(MeasuredSwatch, IsReadFromDisk) {
  const ScratchFolder folder;
  putBytes(folder.file("a.cxf"), cxfText());
  EXPECT_EQ(readSwatches(folder.file("a.cxf")).swatches[0].name, "navy wool");
  EXPECT_THROW(readSwatches(folder.file("none.cxf")), InputError);
}

TEST(MeasuredSwatch, OfTheSamplesIsADarkBlue) {
  const SwatchFile file = readSwatches(LOOMLIGHT_SAMPLES "/swatches/navy_wool_made_up.csv");
  ASSERT_EQ(file.swatches.size(), 1u);
  const Spectrum bands = bandReflectance(file.swatches[0]);
  const auto at = [&](int nm) { return bands[static_cast<size_t>(nm - kFirstBand_nm) / kBandStep_nm]; };
  EXPECT_GT(at(450), 2 * at(600));
  EXPECT_LT(at(450), 0.15f);
}

}  // namespace
}  // namespace loomlight
