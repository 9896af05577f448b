#include "app/cli/option_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cli/usage_error.h"

namespace loomlight {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

template <class Action>
std::string complaint(Action&& action) {
  try {
    action();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(OptionValues, WholeNumbersKeepTheirRange) {
  EXPECT_EQ(parseWhole("--spp", "1", 1, 64), 1);
  EXPECT_EQ(parseWhole("--spp", "64", 1, 64), 64);
  for (const char* text : {"0", "65", "-1", "", " 1", "1 ", "1.5", "x", "0x10", "99999999999999999999"})
    EXPECT_THAT(complaint([&] { parseWhole("--spp", text, 1, 64); }),
                AllOf(HasSubstr("--spp"), HasSubstr("from 1 to 64"), HasSubstr("'" + std::string(text) + "'")));
}

TEST(OptionValues, SeedsAreAll64BitNumbers) {
  EXPECT_EQ(parseSeed("--seed", "0"), 0u);
  EXPECT_EQ(parseSeed("--seed", "18446744073709551615"), ~uint64_t{0});
  EXPECT_THROW(parseSeed("--seed", "18446744073709551616"), UsageError);
  EXPECT_THROW(parseSeed("--seed", "-1"), UsageError);
}

TEST(OptionValues, NumbersAreFinite) {
  EXPECT_DOUBLE_EQ(parseNumber("--exposure", "-1.5", -20, 20), -1.5);
  for (const char* text : {"nan", "inf", "-inf", "1e999", "21", "", "1,5"})
    EXPECT_THROW(parseNumber("--exposure", text, -20, 20), UsageError) << text;
}

TEST(OptionValues, SizesAreTwoSidesOfAPicture) {
  const PictureSize size = parseSize("--size", "640x480");
  EXPECT_EQ(size.width, 640);
  EXPECT_EQ(size.height, 480);
  EXPECT_EQ(parseSize("--size", "16384x1").width, 16384);
  for (const char* text :
       {"640", "640x", "x480", "0x480", "640x0", "16385x1", "640x480x3", "640 x 480", "-1x4", "1e3x4"})
    EXPECT_THAT(complaint([&] { parseSize("--size", text); }), HasSubstr("--size: expected WIDTHxHEIGHT")) << text;
}

TEST(OptionValues, ResolutionsArePowersOfTwo) {
  EXPECT_THAT(parseResolutions("--resolutions", "1,2,4,8,16"), ElementsAre(1, 2, 4, 8, 16));
  for (const char* text : {"0", "3", "32", "", "8.0"}) EXPECT_THROW(parseResolution("--resolution", text), UsageError);
  EXPECT_THROW(parseResolutions("--resolutions", "1,,2"), UsageError);
}

TEST(OptionValues, ViewsAreNamesOrAngles) {
  EXPECT_DOUBLE_EQ(parseView("--view", "top").elevation_deg, 90);
  EXPECT_TRUE(parseView("--view", "close").seenPitches.has_value());
  const ViewChoice angles = parseView("--view", "-30,45.5");
  EXPECT_DOUBLE_EQ(angles.azimuth_deg, -30);
  EXPECT_DOUBLE_EQ(angles.elevation_deg, 45.5);
  EXPECT_FALSE(angles.distance_mm.has_value());
  EXPECT_DOUBLE_EQ(parseView("--view", "0,90,12").distance_mm.value(), 12);
  EXPECT_THAT(complaint([] { parseView("--view", "tpo"); }), AllOf(HasSubstr("front"), HasSubstr("'tpo'")));
  EXPECT_THAT(complaint([] { parseView("--view", "0,91"); }), HasSubstr("--view (elevation)"));
  EXPECT_THROW(parseView("--view", "0,0,0"), UsageError);
  EXPECT_THROW(parseView("--view", "1,2,3,4"), UsageError);
}

TEST(OptionValues, DrapesAreNamesOrMeshes) {
  EXPECT_EQ(parseDrape("--drape", "flat").kind, DrapeKind::flat);
  EXPECT_EQ(parseDrape("--drape", "cylinder").kind, DrapeKind::cylinder);
  EXPECT_EQ(parseDrape("--drape", "sphere").kind, DrapeKind::sphere);
  const DrapeChoice mesh = parseDrape("--drape", "folds/skirt.obj");
  EXPECT_EQ(mesh.kind, DrapeKind::mesh);
  EXPECT_EQ(mesh.file, "folds/skirt.obj");
  EXPECT_THAT(complaint([] { parseDrape("--drape", "cilinder"); }), HasSubstr("flat, cylinder, sphere"));
}

TEST(OptionValues, LightsHaveTheirDetails) {
  EXPECT_EQ(parseLight("--light", "ibl").kind, LightKind::sky);
  const LightChoice environment = parseLight("--light", "ibl:rooms/studio:1.exr");
  EXPECT_EQ(environment.kind, LightKind::environment);
  EXPECT_EQ(environment.file, "rooms/studio:1.exr");
  EXPECT_EQ(parseLight("--light", "point").kind, LightKind::headlight);
  EXPECT_EQ(parseLight("--light", "dome").kind, LightKind::dome);
  EXPECT_EQ(parseLight("--light", "back").kind, LightKind::back);
  EXPECT_EQ(parseLight("--light", "booth").kind, LightKind::booth);
  EXPECT_EQ(parseDrape("--drape", "skirt").kind, DrapeKind::skirt);
  EXPECT_EQ(parseLight("--light", "furnace").kind, LightKind::furnace);
  const LightChoice lamp = parseLight("--light", "directional:30,-40");
  EXPECT_EQ(lamp.kind, LightKind::directional);
  EXPECT_DOUBLE_EQ(lamp.angles.value().azimuth_deg, 30);
  EXPECT_DOUBLE_EQ(lamp.angles.value().elevation_deg, -40);
  EXPECT_FALSE(parseLight("--light", "sky").angles.has_value());
  for (const char* text : {"sun", "dome:1,2", "sky:1", "sky:1,2,3", "sky:0,-5", "directional:x,1", ""})
    EXPECT_THAT(complaint([&] { parseLight("--light", text); }), HasSubstr("--light")) << text;
}

TEST(OptionValues, LampsAreNamedAsEverywhere) {
  const auto lamp = [](const std::string& text) { return parseIlluminant("--illuminant", text); };
  for (const char* name : {"LED-B3", "led_b3", "LED B3"})
    EXPECT_EQ(lamp(name).illuminant, StandardIlluminant::ledB3) << name;
  EXPECT_EQ(lamp("TL84").illuminant, StandardIlluminant::f11);
  EXPECT_EQ(lamp("FL2").illuminant, StandardIlluminant::f2);
  for (const char* name : {"2856K", "2856 k"}) {
    EXPECT_EQ(lamp(name).illuminant, StandardIlluminant::blackBody) << name;
    EXPECT_EQ(lamp(name).temperature_K, 2856) << name;
  }
  EXPECT_EQ(lamp("lamps/own.txt").file, "lamps/own.txt");
  EXPECT_FALSE(lamp("D50").temperature_K.has_value());
  for (const char* name : {"D66", "100 K", "neon"}) EXPECT_THROW(lamp(name), UsageError) << name;
}

}  // namespace
}  // namespace loomlight
