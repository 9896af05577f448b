#include "render/colour/icc_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/base/error.h"
#include "core/base/rgb.h"
#include "render/colour/colour_space.h"
#include "render/film/srgb_profile.h"
#include "tests/support/colour_profiles.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using test::ScratchFolder;

IccProfile display(const cmsCIExyYTRIPLE& primaries, double gamma) {
  return iccProfile(test::savedBytes(test::threePrimaries(primaries, gamma, cmsSigDisplayClass)), "display.icc");
}

IccProfile palePrinter() {
  return iccProfile(test::palePrinterProfile(), "printer.icc");
}

/// Four inks; black alone is used, and prints lightness L = 100 (1 - k): a printer in black and white.
cmsHPROFILE blackInk() {
  cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
  cmsSetProfileVersion(profile, 4.3);
  cmsSetDeviceClass(profile, cmsSigOutputClass);
  cmsSetColorSpace(profile, cmsSigCmykData);
  cmsSetPCS(profile, cmsSigLabData);
  cmsWriteTag(profile, cmsSigMediaWhitePointTag, cmsD50_XYZ());
  const auto table = [&](cmsTagSignature tag, cmsUInt32Number in, cmsUInt32Number out, cmsSAMPLER16 sampler) {
    cmsPipeline* const pipeline = cmsPipelineAlloc(nullptr, in, out);
    cmsStage* const stage = cmsStageAllocCLut16bit(nullptr, 3, in, out, nullptr);
    cmsStageSampleCLut16bit(stage, sampler, nullptr, 0);
    // A table of version 4 lies between curves, here of no effect.
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, in, nullptr));
    cmsPipelineInsertStage(pipeline, cmsAT_END, stage);
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, out, nullptr));
    cmsWriteTag(profile, tag, pipeline);
    cmsPipelineFree(pipeline);
  };
  constexpr cmsUInt16Number kNoHue = 0x8080;  // a* = b* = 0 in version 4
  table(cmsSigAToB0Tag, 4, 3, [](const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
    out[0] = static_cast<cmsUInt16Number>(0xFFFF - in[3]);
    out[1] = out[2] = kNoHue;
    return 1;
  });
  table(cmsSigBToA0Tag, 3, 4, [](const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
    out[0] = out[1] = out[2] = 0;
    out[3] = static_cast<cmsUInt16Number>(0xFFFF - in[0]);
    return 1;
  });
  return profile;
}

constexpr float kStep = 1.0f / 255;

/// XYZ of one unit of each primary, where all three together are D65: by the definition of such a space.
glm::dmat3 xyzFromLight(const cmsCIExyYTRIPLE& primaries) {
  const auto xyz = [](const cmsCIExyY& c) { return glm::dvec3(c.x / c.y, 1, (1 - c.x - c.y) / c.y); };
  const glm::dmat3 unscaled(xyz(primaries.Red), xyz(primaries.Green), xyz(primaries.Blue));
  const glm::dvec3 scale = glm::inverse(unscaled) * xyz(test::kD65);
  return {unscaled[0] * scale[0], unscaled[1] * scale[1], unscaled[2] * scale[2]};
}

ColourCube cubeOf(const IccProfile& profile) {
  return profile.device == IccProfile::Device::display ? displayCube(profile) : proofCube(profile);
}

TEST(IccProfile, OfSrgbChangesNothing) {
  const ColourCube cube = displayCube(iccProfile(sRgbProfile(), "sRGB"));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const Rgb colour(any(random), any(random), any(random));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(cube.at(colour)[c], colour[c], 0.5f * kStep);
  }
}

/// The colours of a display of other primaries and a plain power, from the definition of both spaces.
TEST(IccProfile, SendsADisplayWhatShowsTheColour) {
  const ColourCube cube = displayCube(display(test::kAdobe, 2.2));
  const glm::dmat3 toAdobe = glm::inverse(xyzFromLight(test::kAdobe)) * xyzFromLight(test::kRec709);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> any(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const float scale = i % 2 ? 1.0f : 0.05f;  // half of them dark
    const Rgb linear(scale * any(random), scale * any(random), scale * any(random));
    const glm::dvec3 light = toAdobe * glm::dvec3(linear);
    const glm::vec4 sent = cube.at(srgbFromLinear(linear));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(sent[c], std::pow(std::max(light[c], 0.0), 1 / 2.2), 2 * kStep) << linear.r << " " << linear.g;
  }
}

TEST(IccProfile, KeepsBlackAndWhiteOfADisplay) {
  const ColourCube cube = displayCube(display(test::kAdobe, 2.2));
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(cube.at(Rgb(0.0f))[c], 0, 0.5f * kStep);
    EXPECT_NEAR(cube.at(Rgb(1.0f))[c], 1, 0.5f * kStep);
  }
}

/// Pale colours print as they are; what is purer than any ink comes out paler, and is said to.
TEST(IccProfile, ProofShowsWhatIsOutOfThePrintersGamut) {
  const IccProfile printer = palePrinter();
  EXPECT_EQ(printer.device, IccProfile::Device::printer);
  const ColourCube cube = proofCube(printer);
  const Rgb pale = srgbFromLinear(Rgb(0.45f, 0.40f, 0.42f)), red = srgbFromLinear(Rgb(0.9f, 0.02f, 0.02f));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(cube.at(pale)[c], pale[c], kStep);
  EXPECT_LT(cube.at(pale).a, 1);
  EXPECT_GT(cube.at(red).a, kOutOfGamut_deltaE);
  EXPECT_GT(cube.at(red).g, red.g + 10 * kStep) << "a pale red";
}

TEST(IccProfile, ProofOfInksWithoutColourIsGreyOfEqualLightness) {
  const ColourCube cube = proofCube(iccProfile(test::savedBytes(blackInk()), "black.icc"));
  const glm::vec4 print = cube.at(srgbFromLinear(Rgb(0.1f, 0.3f, 0.1f)));
  EXPECT_NEAR(print.r, print.g, kStep);
  EXPECT_NEAR(print.g, print.b, kStep);
  const Lab wanted = labFromLinear({0.1, 0.3, 0.1});
  const Lab printed = labFromLinear(glm::dvec3(decodeSrgb(print.g)));
  EXPECT_NEAR(printed.L, wanted.L, 1.5);  // D50 and D65 see a green a little differently
  EXPECT_GT(print.a, kOutOfGamut_deltaE);
  // At a corner of the cube: between corners stand neighbours with a hue, which these inks have not.
  EXPECT_LT(cube.at(Rgb(ColourCube::cornerAt(20))).a, 0.1f) << "a grey is in the gamut";
}

void expectRefused(const std::string& bytes, const std::string& words) {
  try {
    iccProfile(bytes, "some.icc");
    FAIL() << "expected: " << words;
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("some.icc"), std::string::npos) << text;
    EXPECT_NE(text.find(words), std::string::npos) << text;
  }
}

TEST(IccProfile, RefusesWhatIsNoProfileOfADisplayOrPrinter) {
  expectRefused("", "expected a colour profile");
  expectRefused(std::string(200, 'x'), "expected a colour profile");
  expectRefused(test::savedBytes(test::threePrimaries(test::kRec709, 2.2, cmsSigInputClass)), "camera or scanner");
  expectRefused(test::savedBytes(test::threePrimaries(test::kRec709, 2.2, cmsSigAbstractClass)),
                "an effect upon colours");
  expectRefused(test::savedBytes(cmsCreateLab4Profile(nullptr)), "expected the profile of a display or a printer");
  cmsToneCurve* const curve = cmsBuildGamma(nullptr, 2.2);
  expectRefused(test::savedBytes(cmsCreateGrayProfile(cmsD50_xyY(), curve)), "of red, green and blue");
  cmsFreeToneCurve(curve);
}

/// Cut at every length, and with any byte another one, a profile is read or refused, no more.
TEST(IccProfile, SurvivesWhatIsBroken) {
  for (const std::string& whole :
       {test::savedBytes(test::threePrimaries(test::kAdobe, 2.2, cmsSigDisplayClass)), test::savedBytes(blackInk())}) {
    const auto tried = [](const std::string& bytes) {
      try {
        const IccProfile profile = iccProfile(bytes, "broken.icc");
        const ColourCube cube = cubeOf(profile);
        const auto isColour = [](const glm::vec4& c) {
          return std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= 1 && c.a >= 0;
        };
        EXPECT_TRUE(std::all_of(cube.corners().begin(), cube.corners().end(), isColour));
      } catch (const InputError& refused) {
        EXPECT_THAT(refused.what(), testing::HasSubstr("broken.icc"));
      }
    };
    std::mt19937 random(3);
    std::uniform_int_distribution<size_t> place(0, whole.size() - 1);
    std::uniform_int_distribution<int> value(0, 255);
    for (int i = 0; i < 25; ++i) {
      tried(whole.substr(0, place(random)));
      std::string bytes = whole;
      for (int k = 0; k < 3; ++k) bytes[place(random)] = static_cast<char>(value(random));
      tried(bytes);
    }
  }
}

TEST(IccProfile, IsReadFromAFile) {
  const ScratchFolder folder;
  const std::string file = folder.file("Screen.icc");
  test::putBytes(file, test::savedBytes(test::threePrimaries(test::kAdobe, 2.2, cmsSigDisplayClass)));
  EXPECT_EQ(readIccProfile(file).device, IccProfile::Device::display);
  EXPECT_FALSE(readIccProfile(file).description.empty());
  EXPECT_THROW(readIccProfile(folder.file("none.icc")), InputError);
}

}  // namespace
}  // namespace loomlight
