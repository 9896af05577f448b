#include "core/fabric/yarn/yarn_name.h"

#include <gtest/gtest.h>

#include "core/base/rgb.h"
#include "core/fabric/yarn/colour_name.h"

namespace loomlight {
namespace {

TEST(ColourName, SaysWhatADyerWould) {
  const std::pair<Rgb, const char*> colours[] = {
      {{255, 255, 255}, "white"}, {{10, 10, 10}, "black"},   {{200, 30, 40}, "red"},      {{25, 35, 75}, "navy"},
      {{120, 125, 128}, "grey"},  {{225, 205, 170}, "ecru"}, {{20, 80, 45}, "dark green"}};
  for (const auto& [srgb, name] : colours) EXPECT_EQ(colourName(linearFromSrgb(srgb / 255.0f)), name);
}

TEST(YarnName, IsColourAndCountUntilSomebodyNamesIt) {
  Fabric fabric;
  fabric.yarns[0].name.clear();
  fabric.yarns[0].count_tex = 2 * 1000.0 / 60;
  fabric.yarns[0].plies = 2;
  const Rgb navy = linearFromSrgb(Rgb(0.1f, 0.14f, 0.29f)), white(1);
  EXPECT_EQ(yarnName(fabric, 0, navy, CountSystem::metric), "navy 2/60 Nm");
  EXPECT_EQ(yarnName(fabric, 0, navy), "navy 16.7 tex x 2");
  fabric.yarns[0].plies = 1;
  EXPECT_EQ(yarnName(fabric, 0, white), "white 33.3 tex") << "it does not follow what the yarn becomes";
  fabric.yarns[0].name = "Aunt Mary's";
  EXPECT_EQ(yarnName(fabric, 0, white), "Aunt Mary's");
}

TEST(WrittenCount, IsThatOfTheTrade) {
  Yarn yarn;
  const Fibre fibre;
  const auto written = [&](double tex, int plies, int cords, CountSystem system) {
    yarn.count_tex = tex;
    yarn.plies = plies;
    yarn.cords = cords;
    return writtenCount(yarn, fibre, system);
  };
  EXPECT_EQ(written(590.5 / 30, 1, 1, CountSystem::cotton), "30 Ne");
  EXPECT_EQ(written(2 * 590.5 / 30, 2, 1, CountSystem::cotton), "30/2 Ne");
  EXPECT_EQ(written(6 * 590.5 / 20, 2, 3, CountSystem::cotton), "20/2/3 Ne");
  EXPECT_EQ(written(180, 2, 3, CountSystem::tex), "30 tex x 2 x 3");
  EXPECT_EQ(written(1500, 1, 1, CountSystem::tex), "1500 tex");
}

TEST(YarnLetters, GoOnAfterZ) {
  EXPECT_EQ(yarnLetters(0), "A");
  EXPECT_EQ(yarnLetters(25), "Z");
  EXPECT_EQ(yarnLetters(26), "AA");
}

}  // namespace
}  // namespace loomlight
