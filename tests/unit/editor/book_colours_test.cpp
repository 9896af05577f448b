#include "app/editor/model/book_colours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "render/colour/colour_space.h"
#include "render/colour/tristimulus.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

TEST(BookColours, WhiteOfEveryLightIsWhite) {
  for (const char* illuminant : {"D50", "D65", "A", "F11", "a light that nobody knows"})
    for (const int degrees : {2, 10}) {
      NamedColour white{"white", Rgb(0), WhiteLab{100, 0, 0, illuminant, degrees}, {}};
      const BookColour shown = bookColour(white);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown.linear[c], 1, 2e-3) << illuminant;
    }
}

TEST(BookColours, LabOfDaylightIsWhatADisplayShows) {
  const Lab lab{52, 40, -12};
  const BookColour shown = bookColour({"x", Rgb(0), WhiteLab{lab.L, lab.a, lab.b, "D65", 2}, {}});
  EXPECT_LT(ciede2000(labFromLinear(glm::dvec3(shown.linear)), lab), 0.05);
  EXPECT_EQ(shown.lab.L, lab.L);
  EXPECT_EQ(shown.lab.observer_degrees, 2);
}

/// What is known for another white is said as it is by day.
TEST(BookColours, AreToldByDay) {
  const BookColour shown = bookColour({"x", Rgb(0), WhiteLab{52, 40, -12, "D50", 2}, {}});
  EXPECT_EQ(shown.lab.illuminant, "D65");
  const Lab told{shown.lab.L, shown.lab.a, shown.lab.b};
  EXPECT_LT(ciede2000(labFromLinear(glm::dvec3(shown.linear)), told), 0.05);
}

TEST(BookColours, AReflectanceCountsBeforeNumbers) {
  Spectrum grey;
  grey.fill(0.2f);
  const BookColour shown = bookColour({"x", Rgb(1, 0, 0), WhiteLab{90, 0, 0, "D50", 2}, grey});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown.linear[c], 0.2f, 1e-3);
  EXPECT_EQ(*shown.measured, grey);
  EXPECT_NEAR(shown.lab.L, 116 * std::cbrt(0.2) - 16, 1e-3);
  EXPECT_EQ(shown.lab.observer_degrees, 10);
}

TEST(BookColours, AFileIsTakenForWhatItHolds) {
  const test::ScratchFolder folder;
  const auto file = [&](const char* name, const std::string& text) {
    test::putBytes(folder.file(name), text);
    return readColourFile(folder.file(name));
  };
  const std::string head = "name,400,420,440,460,480,500,520,540,560,580,600,620,640,660,680,700\n";
  const std::string row = ",.1,.1,.1,.1,.1,.1,.1,.1,.1,.1,.1,.1,.1,.1,.1,.1\n";
  const ColourFile one = file("one.csv", head + "slate" + row);
  ASSERT_TRUE(one.swatch);
  EXPECT_EQ(one.swatch->name, "slate");
  const ColourFile two = file("range.csv", head + "slate" + row + "lead" + row);
  EXPECT_FALSE(two.swatch);
  EXPECT_EQ(two.palette.name, "range");
  ASSERT_EQ(two.palette.colours.size(), 2u);
  EXPECT_EQ(two.palette.colours[1].name, "lead");
  EXPECT_TRUE(two.palette.colours[1].reflectance);
  EXPECT_EQ(file("codes.csv", "name,hex\nink,#102030\nsand,#d0c0a0\n").palette.colours.size(), 2u);
  EXPECT_EQ(file("a.gpl", "GIMP Palette\nName: Autumn\n#\n10 20 30 ink\n").palette.name, "Autumn");
  try {
    file("broken.csv", "name,400,420\nx,0.1\n");
    FAIL() << "is read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("broken.csv"));
  }
}

TEST(BookColours, AreFoundByTheirNames) {
  Palette palette{"Autumn", {{"Ink", Rgb(0), {}, {}}, {"", Rgb(1), {}, {}}}, {}};
  const ColourBook book = colourBook(palette);
  EXPECT_EQ(book.named("ink"), &book.colours[0]);
  EXPECT_EQ(book.named("no. 2"), &book.colours[1]);
  EXPECT_EQ(book.named("in"), nullptr);
}

}  // namespace
}  // namespace loomlight
