#include "app/cli/picture_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/cli/usage_error.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::ElementsAre;

TEST(PictureSeries, NamesFabricsAndFrames) {
  EXPECT_EQ(nameInSeries("a/turn.####.png", "b/denim.json", 7), "a/turn.0007.png");
  EXPECT_EQ(nameInSeries("#.png", "denim.json", 123), "123.png");
  EXPECT_EQ(nameInSeries("a#b/##", "denim.json", 5), "a#b/05");
  EXPECT_EQ(nameInSeries("{}/{}.exr", "b/denim.1.json", std::nullopt), "denim.1/denim.1.exr");
  EXPECT_EQ(nameInSeries("{}-##.exr", "b/#{}.json", 3), "#{}-03.exr");
  EXPECT_EQ(nameInSeries("#1.png", "denim.json", std::nullopt), "#1.png");
}

TEST(PictureSeries, ATurnComesBackToItsBeginning) {
  Fabric fabric;
  fabric.camera.azimuth_deg = -90;
  const Turntable turn{Turntable::What::camera, 8, 360};
  EXPECT_EQ(inFrame(fabric, turn, 1).camera.azimuth_deg, -90);
  EXPECT_DOUBLE_EQ(inFrame(fabric, turn, 2).camera.azimuth_deg, -45);
  EXPECT_DOUBLE_EQ(inFrame(fabric, turn, 8).camera.azimuth_deg, -135);
  EXPECT_DOUBLE_EQ(inFrame(fabric, turn, 9).camera.azimuth_deg, -90);
  EXPECT_EQ(inFrame(fabric, turn, 5).light, fabric.light);
}

TEST(PictureSeries, ALightIsSweptOnlyWhereItHasADirection) {
  Fabric fabric;
  fabric.light.azimuth_deg = 130;
  const Turntable sweep{Turntable::What::light, 3, -90};
  EXPECT_DOUBLE_EQ(inFrame(fabric, sweep, 3).light.azimuth_deg, 70);
  EXPECT_EQ(inFrame(fabric, sweep, 3).camera, fabric.camera);
  fabric.light.kind = LightKind::dome;
  EXPECT_THROW(inFrame(fabric, sweep, 1), UsageError);
}

TEST(PictureSeries, ParsesWhatIsTurnedAndWhichFrames) {
  EXPECT_EQ(parseTurntable("--turn", "camera").frames, 36);
  const Turntable sweep = parseTurntable("--turn", "light:24,-90.5");
  EXPECT_EQ(sweep.what, Turntable::What::light);
  EXPECT_EQ(sweep.frames, 24);
  EXPECT_EQ(sweep.degrees, -90.5);
  EXPECT_EQ(parseFrames("--frames", "3..7").last, 7);
  EXPECT_EQ(parseFrames("--frames", "3").last, 3);
  for (const char* wrong : {"", "moon", "camera:", "camera:0", "camera:2,", "camera:2,x", "light;3"})
    EXPECT_THROW(parseTurntable("--turn", wrong), UsageError) << wrong;
  for (const char* wrong : {"", "0", "7..3", "1..", "..4", "1-4"})
    EXPECT_THROW(parseFrames("--frames", wrong), UsageError) << wrong;
}

TEST(PictureSeries, AListNamesFilesFromItsFolder) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("list.txt")) << "# ours\nb/denim.json\n\n/c/twill.wif\r\n./#4 twill.json\n";
  EXPECT_THAT(namesInList(folder.file("list.txt")),
              ElementsAre(folder.file("b/denim.json"), "/c/twill.wif", folder.file("./#4 twill.json")));
}

// Editors of Windows put a mark before UTF-8, or write UTF-16; names of files elsewhere may be of no encoding at all.
TEST(PictureSeries, AListMayBeMarkedAsUnicodeAndItsNamesBeAnyBytes) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("marked.txt")) << "\xEF\xBB\xBF/twill.json\r\n/na\xC3\xAFve.json\r\n";
  EXPECT_THAT(namesInList(folder.file("marked.txt")), ElementsAre("/twill.json", "/na\xC3\xAFve.json"));
  std::ofstream(folder.file("wide.txt")) << std::string("\xFF\xFE/\0a\0\n\0", 8);
  EXPECT_THAT(namesInList(folder.file("wide.txt")), ElementsAre("/a"));
  for (const char* mark : {"", "\xEF\xBB\xBF"}) {
    std::ofstream(folder.file("bytes.txt")) << mark << "/na\xEFve.json\n";
    EXPECT_THAT(namesInList(folder.file("bytes.txt")), ElementsAre("/na\xEFve.json"));
  }
}

}  // namespace
}  // namespace loomlight
