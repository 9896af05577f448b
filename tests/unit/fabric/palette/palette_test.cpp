#include "core/fabric/palette/palette.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/rgb.h"
#include "tests/support/mutated.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/fabric/swatch/swatch_texts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using namespace test;

/// Most significant byte first.
std::string big(uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xFF);
  return text;
}

std::string bigFloat(float value) {
  return big(std::bit_cast<uint32_t>(value), 4);
}

std::string wide(const std::string& name) {
  std::string text;
  for (const char c : name) text += big(static_cast<uint8_t>(c), 2);
  return text + big(0, 2);
}

std::string aseColour(const std::string& name, const std::string& model, const std::vector<float>& parts) {
  std::string block = big(name.size() + 1, 2) + wide(name) + model;
  for (const float part : parts) block += bigFloat(part);
  block += big(2, 2);
  return big(1, 2) + big(block.size(), 4) + block;
}

std::string aseFile() {
  const std::string group = big(6, 2) + wide("Sails");
  return "ASEF" + big(1, 2) + big(0, 2) + big(6, 4) + big(0xC001, 2) + big(group.size(), 4) + group +
         aseColour("navy", "RGB ", {0.1f, 0.2f, 0.5f}) + aseColour("ecru", "LAB ", {0.9f, 2, 12}) +
         aseColour("ink", "CMYK", {1, 0, 0, 0.5f}) + aseColour("grey", "Gray", {0.5f}) + big(0xC002, 2) + big(0, 4);
}

std::string acoFile() {
  const auto colour = [](int space, const std::vector<int>& numbers) {
    std::string text = big(static_cast<uint64_t>(space), 2);
    for (const int number : numbers) text += big(static_cast<uint16_t>(number), 2);
    return text;
  };
  const std::vector<std::string> colours{colour(0, {65535, 0, 0, 0}), colour(1, {43690, 65535, 65535, 0}),
                                         colour(7, {9000, -1200, 1250, 0}), colour(8, {10000, 0, 0, 0}),
                                         colour(3, {1, 2, 3, 4})};
  std::string one = big(1, 2) + big(colours.size(), 2), two = big(2, 2) + big(colours.size(), 2);
  for (const std::string& each : colours) {
    one += each;
    two += each + big(6, 4) + wide("paint");
  }
  return one + two;
}

const char* const kGpl = "GIMP Palette\nName: Shore\nColumns: 4\n# two\n  0   0 255\tdeep sea\n255 255 255 Untitled\n";

void expectSrgb(const NamedColour& colour, const glm::dvec3& encoded) {
  const Rgb linear = linearFromSrgb(Rgb(encoded));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour.linear[c], linear[c], 1e-5) << colour.name;
  EXPECT_FALSE(colour.lab || colour.reflectance);
}

TEST(PaletteFile, OfAdobeSwatchExchangeIsRead) {
  const Palette palette = paletteFrom(aseFile(), "a.ase");
  EXPECT_EQ(palette.name, "Sails");
  ASSERT_EQ(palette.colours.size(), 4u);
  EXPECT_EQ(palette.colours[0].name, "navy");
  expectSrgb(palette.colours[0], {0.1, 0.2, 0.5});
  ASSERT_TRUE(palette.colours[1].lab);
  EXPECT_NEAR(palette.colours[1].lab->L, 90, 1e-4);
  EXPECT_NEAR(palette.colours[1].lab->b, 12, 1e-4);
  EXPECT_EQ(palette.colours[1].lab->illuminant, "D50");
  expectSrgb(palette.colours[2], {0, 0.5, 0.5});
  expectSrgb(palette.colours[3], {0.5, 0.5, 0.5});
  EXPECT_THAT(palette.remarks, Contains(HasSubstr("four inks")));
}

TEST(PaletteFile, OfPhotoshopIsReadWithItsNames) {
  const Palette palette = paletteFrom(acoFile(), "x.aco");
  ASSERT_EQ(palette.colours.size(), 4u);
  expectSrgb(palette.colours[0], {1, 0, 0});
  expectSrgb(palette.colours[1], {0, 0, 1});  // two thirds of the circle
  EXPECT_NEAR(palette.colours[2].lab->a, -12, 1e-9);
  EXPECT_NEAR(palette.colours[2].lab->b, 12.5, 1e-9);
  expectSrgb(palette.colours[3], {1, 1, 1});
  EXPECT_EQ(palette.colours[0].name, "paint");
  EXPECT_THAT(palette.remarks, Contains(HasSubstr("left out: 1")));
}

TEST(PaletteFile, OfGimpIsRead) {
  const Palette palette = paletteFrom(kGpl, "shore.gpl");
  EXPECT_EQ(palette.name, "Shore");
  ASSERT_EQ(palette.colours.size(), 2u);
  EXPECT_EQ(palette.colours[0].name, "deep sea");
  expectSrgb(palette.colours[0], {0, 0, 1});
  EXPECT_EQ(palette.colours[1].name, "Shore 2");
}

TEST(PaletteFile, OfABookHasReflectancesOrElseLab) {
  const Palette spectra = paletteFrom(cxfText(), "book.cxf");
  ASSERT_EQ(spectra.colours.size(), 1u);
  EXPECT_EQ(spectra.colours[0].name, "navy wool");
  ASSERT_TRUE(spectra.colours[0].reflectance);
  EXPECT_NEAR((*spectra.colours[0].reflectance)[2], swatchValue(0), 1e-6);
  std::string text = cxfText();
  const size_t from = text.find("<cc:ReflectanceSpectrum"), to = text.find("<cc:ColorCIELab");
  text.erase(from, to - from);
  text.insert(text.find("<cc:MeasurementSpec>"),
              "<cc:TristimulusSpec><cc:Illuminant>D65</cc:Illuminant><cc:Observer>10_Degree"
              "</cc:Observer></cc:TristimulusSpec>");
  const Palette lab = paletteFrom(text, "book.cxf");
  ASSERT_TRUE(lab.colours.at(0).lab);
  EXPECT_EQ(lab.colours[0].lab->b, -20);
  EXPECT_EQ(lab.colours[0].lab->illuminant, "D65");
  EXPECT_EQ(lab.colours[0].lab->observer_degrees, 10);
}

TEST(PaletteFile, OfATableIsReadByItsTitles) {
  const Palette hex = paletteFrom("Name;Hex\nsea;#0000ff\n", "a.csv");
  EXPECT_EQ(hex.colours[0].name, "sea");
  expectSrgb(hex.colours[0], {0, 0, 1});
  const Palette lab = paletteFrom("code,L*,a*,b*\nS 10,52.5,-3,4\n", "a.csv");
  EXPECT_EQ(lab.colours[0].name, "S 10");
  EXPECT_EQ(lab.colours[0].lab->L, 52.5);
  EXPECT_THAT(lab.remarks, Contains(HasSubstr("D50")));
  const Palette bytes = paletteFrom("R,G,B,name\n0,0,255,sea\n0,0,1,night\n", "a.csv");
  expectSrgb(bytes.colours[0], {0, 0, 1});
  expectSrgb(bytes.colours[1], {0, 0, 1 / 255.0});
  const Palette fractions = paletteFrom("R,G,B,name\n0,0,0.5,sea\n", "a.csv");
  expectSrgb(fractions.colours[0], {0, 0, 0.5});
  const Palette plain = paletteFrom("sea,#0000FF\n#FF0000,fire\n", "a.csv");
  EXPECT_EQ(plain.colours[1].name, "fire");
  EXPECT_TRUE(paletteFrom(csvOfColumns(), "a.csv").colours[1].reflectance);
}

/// What stands in quotes may have commas in it (RFC 4180).
TEST(PaletteFile, OfATableMayHaveQuotedCells) {
  const Palette quoted =
      paletteFrom("name,hex\n\"navy, dark\",#00007f\n\"the \"\"old\"\", one\" , \"#ff0000\"\n", "a.csv");
  ASSERT_EQ(quoted.colours.size(), 2u);
  EXPECT_EQ(quoted.colours[0].name, "navy, dark");
  expectSrgb(quoted.colours[1], {1, 0, 0});
  EXPECT_EQ(paletteFrom("name,hex\n3\" wide,#00007f\n", "a.csv").colours[0].name, "3\" wide");
}

/// Instruments round, and no white is more than white.
TEST(PaletteFile, LightnessIsAHundredAtMost) {
  EXPECT_EQ(paletteFrom("name,L,a,b\nwhite,100.3,0,0\n", "a.csv").colours[0].lab->L, 100);
  EXPECT_THROW(paletteFrom("name,L,a,b\nwhite,101,0,0\n", "a.csv"), InputError);
}

TEST(PaletteFile, ThatIsMistakenIsRefusedWithItsPlace) {
  const auto complaint = [](const std::string& bytes, const std::string& source) {
    return messageOf<InputError>([&] { paletteFrom(bytes, source); });
  };
  EXPECT_THAT(complaint(aseFile().substr(0, 60), "a.ase"), HasSubstr("the file ends"));
  EXPECT_THAT(complaint("ASEF" + big(1, 2) + big(0, 2) + big(0, 4), "a.ase"), HasSubstr("there are none"));
  EXPECT_THAT(complaint("ASEF" + big(1, 2) + big(0, 2) + big(1, 4) + aseColour("x", "RGB ", {1, 7, 0}), "a.ase"),
              HasSubstr("a.ase: byte 24: expected red, green and blue"));
  EXPECT_THAT(
      complaint("ASEF" + big(1, 2) + big(0, 2) + big(1, 4) + aseColour(std::string(1, '\0') + "x", "RGB ", {1, 1, 1}),
                "a.ase"),
      HasSubstr("a.ase: byte 20: expected a text"));
  EXPECT_THAT(complaint(acoFile().substr(0, 30), "a.aco"), HasSubstr("the file ends"));
  EXPECT_THAT(complaint("GIMP Palette\n1 2\n", "a.gpl"), HasSubstr("line 2"));
  EXPECT_THAT(complaint("GIMP Palette\n1 2 256 x\n1 2 999 x\n", "a.gpl"), HasSubstr("line 3"));
  EXPECT_THAT(complaint("name,hex\nsea,#00ff\n", "a.csv"), HasSubstr("line 2"));
  EXPECT_THAT(complaint("name,L,a,b\nsea,500,0,0\n", "a.csv"), HasSubstr("CIELAB"));
  EXPECT_THAT(complaint("name,L,a,b\nsea,50,0\n", "a.csv"), HasSubstr("column 4"));
  EXPECT_THAT(complaint("<CxF/>", "a.cxf"), HasSubstr("there are none"));
  EXPECT_THROW(paletteFrom("", "a.gpl"), InputError);
}

TEST(PaletteFile, OfAnyDamageIsReadOrRefused) {
  Random random(18);
  const std::pair<std::string, const char*> files[] = {{aseFile(), "a.ase"},
                                                       {acoFile(), "a.aco"},
                                                       {kGpl, "a.gpl"},
                                                       {cxfText(), "a.cxf"},
                                                       {"Name;Hex\nsea;#0000ff\n", "a.csv"}};
  for (const auto& [whole, name] : files)
    for (int i = 0; i < 150; ++i) {
      try {
        for (const NamedColour& colour : paletteFrom(mutated(whole, random), name).colours)
          for (int c = 0; c < 3; ++c) EXPECT_TRUE(colour.linear[c] >= 0 && colour.linear[c] <= 1);
      } catch (const InputError& refused) {
        EXPECT_THAT(refused.what(), testing::HasSubstr(name));
      }
    }
}

}  // namespace
}  // namespace loomlight
