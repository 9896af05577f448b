#include "render/colour/illuminants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

double powerAt(const Illuminant& light, int nm) {
  return light.power[nm - kFirstVisible_nm];
}

glm::dvec2 chromaticity(const Illuminant& light, Observer observer) {
  glm::dvec3 xyz(0);
  for (size_t i = 0; i < kVisible; ++i) xyz += light.power[i] * matchingFunctions(observer)[i];
  return glm::dvec2(xyz.x, xyz.y) / (xyz.x + xyz.y + xyz.z);
}

struct PublishedWhite {
  const char* name;
  glm::dvec2 of2, of10;
};

// CIE 15:2004, tables T.3 and T.8. Those of lamps are sums at 5 nm, which spiky spectra tell from sums at 1 nm.
const PublishedWhite kPublishedWhites[] = {
    {"A", {0.44758, 0.40745}, {0.45117, 0.40594}},   {"D65", {0.31272, 0.32903}, {0.31381, 0.33098}},
    {"D50", {0.34567, 0.35851}, {0.34773, 0.35952}}, {"D55", {0.33243, 0.34744}, {0.33412, 0.34877}},
    {"F2", {0.3721, 0.3751}, {0.37925, 0.36733}},    {"F7", {0.3129, 0.3292}, {0.31569, 0.32960}},
    {"F11", {0.3805, 0.3769}, {0.38541, 0.37123}},
};

TEST(Illuminants, HaveTheChromaticitiesOfTheStandard) {
  for (const PublishedWhite& published : kPublishedWhites) {
    const Illuminant light = illuminantNamed(published.name);
    const glm::dvec2 of2 = chromaticity(light, Observer::degrees2), of10 = chromaticity(light, Observer::degrees10);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(of2[i], published.of2[i], 3e-4) << published.name;
      EXPECT_NEAR(of10[i], published.of10[i], 3e-4) << published.name;
    }
  }
}

TEST(Illuminants, OfLedsAreWarmAndCoolInTheirOrder) {
  // B1 to B5 are of 2733, 2998, 4103, 5109 and 6598 K.
  double last = 1;
  for (const char* name : {"LED-B1", "LED-B2", "LED-B3", "LED-B4", "LED-B5"}) {
    const double x = chromaticity(illuminantNamed(name), Observer::degrees2).x;
    EXPECT_LT(x, last) << name;
    last = x;
  }
  EXPECT_NEAR(chromaticity(illuminantNamed("LED-B1"), Observer::degrees2).x, 0.4560, 3e-4);
  EXPECT_NEAR(chromaticity(illuminantNamed("LED-B5"), Observer::degrees2).x, 0.3118, 3e-4);
}

TEST(Illuminants, AreNamedAsPeopleNameThem) {
  EXPECT_EQ(illuminantNamed("tl84").power, illuminantNamed("F11").power);
  EXPECT_EQ(illuminantNamed("FL2").name, "F2");
  EXPECT_EQ(illuminantNamed("led-b3").name, "LED-B3");
  EXPECT_EQ(illuminantNamed("2856k").name, "2856 K");
  for (const std::string& name : lampNames()) EXPECT_EQ(illuminantNamed(name).name, name);
}

TEST(Illuminants, BlackBodyOf2856KelvinIsA) {
  const Illuminant body = illuminantNamed("2856 K"), a = illuminantNamed("A");
  for (size_t i = 0; i < kVisible; ++i) EXPECT_NEAR(body.power[i] / a.power[i], 1, 1e-3);
}

TEST(Illuminants, OfOtherNamesAreRefusedWithAList) {
  for (const char* name :
       {"", "D66", "F", "FL", "K", "-5 K", "nan K", "100 K", "1e9 K", "2856", "2856 KK", "TL", "FLED-B1"})
    EXPECT_THROW(illuminantNamed(name), InputError) << name;
  try {
    illuminantCalled("neon");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("LED-B5"));
  }
}

class IlluminantFile : public ::testing::Test {
 protected:
  Illuminant read(const std::string& text) {
    const std::string file = folder_.file("lamp.txt");
    test::putBytes(file, text);
    return illuminantCalled(file);
  }

  std::string complaint(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  test::ScratchFolder folder_;
};

TEST_F(IlluminantFile, IsReadInAllItsPunctuation) {
  const Illuminant light = read("nm;power # measured\r\n\r\n# a comment\r\n380, 1\r\n480\t2\r\n580 ;4\r\n730 1\r\n");
  EXPECT_EQ(light.name, "lamp");
  EXPECT_NEAR(powerAt(light, 430) / powerAt(light, 580), 1.5 / 4, 1e-12);
  EXPECT_NEAR(powerAt(light, 530) / powerAt(light, 580), 3.0 / 4, 1e-12);
  EXPECT_EQ(powerAt(light, 360), powerAt(light, 380));
  EXPECT_EQ(powerAt(light, 780), powerAt(light, 730));
}

/// As spreadsheets and old programs save them.
TEST_F(IlluminantFile, IsReadInAnyEncodingOfText) {
  const std::string text = "# of a shop\nnm,power\n380,1\n580,4\n730,1\n";
  std::string wide = "\xFF\xFE", old = text;
  for (const char c : text) wide += {c, '\0'};
  std::replace(old.begin(), old.end(), '\n', '\r');
  for (const std::string& bytes : {"\xEF\xBB\xBF" + text, wide, old}) {
    EXPECT_EQ(read(bytes).power, read(text).power);
    EXPECT_TRUE(isIlluminantFile(folder_.file("lamp.txt")));
  }
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "380,1\n580,4\n730,1\n")
                .power,
            read(text).power)
      << "the first line is none of titles";
}

TEST_F(IlluminantFile, IsKnownByItsFirstLineOfNumbers) {
  const auto isOne = [&](const std::string& text) {
    test::putBytes(folder_.file("some.txt"), text);
    return isIlluminantFile(folder_.file("some.txt"));
  };
  EXPECT_TRUE(isOne("# of a shop\nnm power\n\n380 1\n"));
  EXPECT_TRUE(isOne("300,0.03\n")) << "it is short, which is said when it is read";
  EXPECT_FALSE(isOne(""));
  EXPECT_FALSE(isOne("380 1 7\n390 1 7\n400 1 7\n"));
  EXPECT_FALSE(isOne("[WIF]\nVersion=1.1\n380 1\n")) << "a draft";
  EXPECT_FALSE(isIlluminantFile(folder_.file("none.txt")));
}

TEST_F(IlluminantFile, SaysWhereItIsWrong) {
  using testing::HasSubstr;
  EXPECT_THAT(complaint("380 1\n480 x\n730 1\n"), HasSubstr("lamp.txt: line 2: expected two numbers"));
  EXPECT_THAT(complaint("380 1\n480 1 7\n730 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(complaint("380 1\n480 nan\n730 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(complaint("380 1\n380 1\n730 1\n"), HasSubstr("ascend"));
  EXPECT_THAT(complaint("380 1\n480 -1\n730 1\n"), HasSubstr("power of 0 or more"));
  EXPECT_THAT(complaint("0.38 1\n0.73 1\n"), HasSubstr("from 0.38 to 0.73"));
  EXPECT_THAT(complaint("400 1\n700 1\n"), HasSubstr("from 380 nm"));
  EXPECT_THAT(complaint(""), HasSubstr("two columns"));
  EXPECT_THAT(complaint("wavelength power\nand more\n"), HasSubstr("line 2"));
  EXPECT_THAT(complaint("380 0\n730 0\n"), HasSubstr("has power"));
  EXPECT_THAT(complaint("380 1e-320\n730 0\n"), HasSubstr("has power"));
  EXPECT_THROW(illuminantCalled(folder_.file("none.txt")), InputError);
}

}  // namespace
}  // namespace loomlight
