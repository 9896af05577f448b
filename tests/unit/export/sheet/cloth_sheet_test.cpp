#include "app/export/sheet/cloth_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <vector>

#include "app/export/sheet/cloth_sheet_page.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/weave/jacquard.h"
#include "tests/support/open_cloth.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Of a name that needs more than ASCII.
Fabric openCloth() {
  Fabric fabric = test::openCloth();
  fabric.name = "Open \xE2\x80\x9Ctwill\xE2\x80\x9D";
  fabric.description = "Woven as it comes.";
  return fabric;
}

class ClothSheet : public testing::Test {
 protected:
  std::string write(const Fabric& fabric, const std::string& name = "sheet.pdf") {
    ClothSheetOptions options;
    options.samplesPerPixel = 1;
    const std::string file = (folder_.path() / name).string();
    EXPECT_TRUE(writeClothSheet(file, fabric, options, {}));
    return readFile(file, 50'000'000);
  }
  test::ScratchFolder folder_;
};

/// Colours are traced after the pictures, for some seconds, in which a full bar would say that all is done.
TEST_F(ClothSheet, TellsHowFarItIsUntilTheEnd) {
  std::mutex mutex;
  std::vector<double> told;
  Task task;
  task.progress = [&](double fraction) {
    const std::lock_guard lock(mutex);
    if (told.empty() || fraction > told.back()) told.push_back(fraction);
  };
  Fabric fabric = openCloth();
  fabric.colourways = {colourwayOf(fabric, "Moss")};
  ClothSheetOptions options;
  options.samplesPerPixel = 1;
  ASSERT_TRUE(writeClothSheet(folder_.file("sheet.pdf"), fabric, options, task));
  EXPECT_THAT(readFile(folder_.file("sheet.pdf"), 50'000'000), StartsWith("%PDF-"));
  ASSERT_FALSE(told.empty());
  EXPECT_GT(told.back(), 0.5);
  // Of one sample a pixel, the picture of the cloth is a third of the work.
  const auto isOfPicture = [](double fraction) { return fraction > 0.05 && fraction < 0.3; };
  EXPECT_GT(std::count_if(told.begin(), told.end(), isOfPicture), 4) << "its bar stands still for seconds";
  EXPECT_LT(told.back(), 1) << "it is full before the end";
}

/// As all our pictures do, it says that its colours are sRGB; and how large it is: 200 dots an inch are 7874 a metre.
TEST_F(ClothSheet, IsAPictureThatPrintsAtItsSize) {
  const std::string metre = {0, 0, 0x1E, static_cast<char>(0xC2)};
  const std::string png = write(openCloth(), "sheet.png");
  EXPECT_THAT(png, HasSubstr("sRGB"));
  EXPECT_THAT(png, HasSubstr("pHYs" + metre + metre + '\1'));
  const PictureExtent page = readPngExtent(folder_.file("sheet.png"));
  EXPECT_EQ(page.width, 1653);
  EXPECT_EQ(page.height, 2338);
}

TEST_F(ClothSheet, PagesOfAPictureLieBelowEachOther) {
  Paper paper(kSheetWidth_mm, kSheetHeight_mm, 2);
  const Pixels8 black{1, 1, 3, {0, 0, 0}};
  layOutColourways(paper, "Moss", std::vector<NamedPiece>(40, {"Moss", black}));
  paper.write(folder_.file("pages.png"));
  const Pixels8 sheet = readPng(folder_.file("pages.png"));
  ASSERT_GE(sheet.height, 3 * 594);
  ASSERT_EQ(sheet.height % 594, 0);
  const auto isBlack = [&](int page, double x_mm, double y_mm) {
    const auto row = static_cast<size_t>(594 * page + 2 * y_mm), column = static_cast<size_t>(2 * x_mm);
    return sheet.bytes[3 * (row * static_cast<size_t>(sheet.width) + column)] == 0;
  };
  for (int page = 0; page < sheet.height / 594; ++page) {
    EXPECT_TRUE(isBlack(page, 40, 60)) << "the first piece of page " << page;
    EXPECT_FALSE(isBlack(page, 5, 60)) << "the margin";
  }
}

/// Such as the address of a page in the notes: nothing leaves the room that it has, however long it is.
TEST_F(ClothSheet, AWordThatIsTooLongIsCutOff) {
  Paper paper(kSheetWidth_mm, kSheetHeight_mm);
  const std::string endless(100'000, 'w');
  paper.paragraph(20, 30, "See " + endless + " and " + endless, {}, 60, 5);
  for (const Paper::Box& box : paper.boxes()) EXPECT_LE(box.width, 60) << box.text.size();
  EXPECT_GE(paper.boxes().size(), 3u);
}

TEST_F(ClothSheet, TakesAJacquardAndSixtyYarns) {
  Fabric fabric = openCloth();
  fabric.weave = damaskJacquard(400, 300);
  fabric.yarns.resize(60, fabric.yarns[0]);
  fabric.warpSequence.clear();
  for (int i = 0; i < 60; ++i) fabric.warpSequence.insert(fabric.warpSequence.end(), 7, i);
  EXPECT_THAT(write(fabric), StartsWith("%PDF-"));
}

TEST_F(ClothSheet, ColourwaysGoOnPagesOfTheirOwn) {
  Fabric fabric = openCloth();
  fabric.colourways = {colourwayOf(fabric, "Moss")};
  ClothSheetOptions options;
  options.samplesPerPixel = 1;
  const std::string file = (folder_.path() / "colourways.pdf").string();
  EXPECT_TRUE(writeColourwaySheet(file, fabric, options, {}));
  EXPECT_THAT(readFile(file, 50'000'000), StartsWith("%PDF-"));
}

/// What tracing would find, white and wide.
ClothSheetContent blankContent(const Fabric& fabric) {
  ClothSheetContent content;
  content.cloth = Pixels8{1, 1, 3, {255, 255, 255}};
  content.colourways.resize(std::min(fabric.colourways.size(), kSheetColourways), content.cloth);
  content.measures = {1.23, 0.288, 0.288, 888.8, 0};
  content.faces.resize(4, FaceColour{"a fibre of which much is to be told, dyed in the piece",
                                     Rgb(1),
                                     {88.8f, -88.8f, -88.8f},
                                     {88.8f, -88.8f, -88.8f},
                                     88.8});
  content.yarnColours.resize(fabric.yarns.size(), Rgb(1));
  content.coloursOfNames = content.yarnColours;
  return content;
}

using Boxes = std::vector<Paper::Box>;

Boxes layOut(const Fabric& fabric, const std::vector<StandardMatch>& matches = {}) {
  Paper paper(kSheetWidth_mm, kSheetHeight_mm);
  ClothSheetOptions options;
  options.width_cm = 8888;
  ClothSheetContent content = blankContent(fabric);
  content.matches = matches;
  layOutClothSheet(paper, fabric, options, content);
  return paper.boxes();
}

/// No text runs into another, into a picture, or over the margin.
void expectApart(const Boxes& boxes) {
  const auto called = [](const Paper::Box& box) { return box.text.empty() ? std::string("a picture") : box.text; };
  for (size_t i = 0; i < boxes.size(); ++i) {
    const Paper::Box& a = boxes[i];
    constexpr double kRounding_mm = 0.3;
    EXPECT_GE(a.x, kSheetMargin_mm - kRounding_mm) << called(a);
    EXPECT_GE(a.y, kSheetMargin_mm - kRounding_mm) << called(a);
    EXPECT_LE(a.x + a.width, kSheetWidth_mm - kSheetMargin_mm + kRounding_mm) << called(a);
    EXPECT_LE(a.y + a.height, kSheetHeight_mm - kSheetMargin_mm + 1) << called(a);
    for (size_t k = 0; k < i; ++k) {
      const Paper::Box& b = boxes[k];
      const bool meet = a.page == b.page && a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
                        b.y < a.y + a.height;
      EXPECT_FALSE(meet) << called(a) << " over " << called(b) << " on page " << a.page + 1;
    }
  }
}

bool says(const Boxes& boxes, const std::string& text) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Paper::Box& box) { return box.text == text; });
}

/// As large as so many can be, for a repeat of stripes is wide; and on one page as long as they are a dozen.
TEST(ClothSheetPage, ColourwaysFillThePage) {
  for (const size_t count : {1u, 2u, 4u, 5u, 6u, 7u, 12u}) {
    SCOPED_TRACE(count);
    Paper paper(kSheetWidth_mm, kSheetHeight_mm);
    layOutColourways(paper, "Tartan", std::vector<NamedPiece>(count, {"Hunting", Pixels8{1, 1, 3, {255, 255, 255}}}));
    expectApart(paper.boxes());
    double end_mm = 0;
    for (const Paper::Box& box : paper.boxes()) {
      EXPECT_EQ(box.page, 0);
      end_mm = std::max(end_mm, box.y + box.height);
    }
    const bool isFull = count == 5 || count == 6 || count == 12;
    if (isFull) {
      EXPECT_GT(end_mm, 0.85 * kSheetHeight_mm);
    }
  }
}

TEST(ClothSheetPage, NothingOverlapsInAnySample) {
  for (const char* const folder : {LOOMLIGHT_SAMPLES, LOOMLIGHT_SAMPLES "/cloths"})
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      if (file.path().extension() != ".json") continue;
      SCOPED_TRACE(file.path().filename());
      const Boxes boxes = layOut(readFabric(file.path().string()));
      expectApart(boxes);
      EXPECT_EQ(boxes.back().page, 0) << "what the trade sells fits on one page";
    }
}

TEST(ClothSheetPage, NothingOverlapsWhereAllIsAsWideAsItCanBe) {
  Fabric fabric = openCloth();
  const std::string wide = "Wide woven worsted of which there is very much to be said and written down ";
  for (int i = 0; i < 4; ++i) fabric.name += wide;
  for (int i = 0; i < 40; ++i) fabric.description += wide;
  fabric.ends_per_cm = fabric.picks_per_cm = 88.8;
  fabric.yarns[0].name = wide;
  fabric.yarns[0].plies = fabric.yarns[0].cords = 4;
  fabric.yarns[0].blendFibre = 0;
  fabric.fibres[0].name = wide;
  fabric.yarns.resize(64, fabric.yarns[0]);
  fabric.warpSequence.clear();
  for (int i = 0; i < 64; ++i) fabric.warpSequence.insert(fabric.warpSequence.end(), 88, i);
  fabric.weftSequence = fabric.warpSequence;
  for (int i = 0; i < 8; ++i) fabric.colourways.push_back(colourwayOf(fabric, wide));
  fabric.mill.reed_per_10cm = 444.4;
  fabric.mill.endsPerDent.assign(60, 64);
  fabric.warpSpacing.assign(16, 1.2345678);
  fabric.weftSpacing = fabric.warpSpacing;
  fabric.mill.selvedgeEnds = 888;
  fabric.mill.selvedgeYarn = 63;
  fabric.mill.selvedgeWeave = wide;
  fabric.mill.loomEnds_per_cm = fabric.mill.washedPicks_per_cm = 488.8;
  const Boxes boxes = layOut(fabric);
  expectApart(boxes);
  EXPECT_TRUE(says(boxes, "BL")) << "the last of 64 yarns, on another page";
}

StandardMatch matchOf(const std::string& of, const std::string& standard, double cmc, double difference) {
  Judgement judgement;
  judgement.ciede2000 = difference;
  judgement.cmc = cmc;
  judgement.metamerism = difference;
  return {of, standard, Rgb(1), Rgb(1), judgement, judgement};
}

/// What is wide is cut off.
TEST(ClothSheetPage, JudgesTheClothBesideItsStandards) {
  const std::string wide = "a standard of which there is very much to be said and written down";
  StandardMatch close = matchOf("Cloth", "lot 7", 0.88, 0.77);
  close.bulb.cmc = 1.23;
  const Boxes boxes = layOut(openCloth(), {close, matchOf(wide, wide, 888.88, 188.88)});
  expectApart(boxes);
  for (const char* const text : {"Beside its standard, tolerance 1 CMC(2:1)", "Cloth", "lot 7", "0.77,  0.88  pass",
                                 "0.77,  1.23  FAIL", "188.88,  888.88  FAIL", "0.77"})
    EXPECT_TRUE(says(boxes, text)) << text;
  expectApart(layOut(openCloth(), std::vector<StandardMatch>(99, close)));
  for (const Paper::Box& box : layOut(openCloth())) EXPECT_THAT(box.text, testing::Not(StartsWith("Beside")));
}

TEST(ClothSheetPage, OrdersAreTables) {
  Fabric fabric = openCloth();
  fabric.yarns.resize(3, fabric.yarns[0]);
  fabric.ends_per_cm = 20;
  fabric.warpSequence = {0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
  const Boxes boxes = layOut(fabric);
  for (const char* const cell : {"ends", "6", "0.30", "0.10", "4", "0.20", "12", "0.60"})
    EXPECT_TRUE(says(boxes, cell)) << cell;
}

/// Below the rule that closes a table there is as much room as below the one that opens it.
TEST(ClothSheetPage, TheSumOfAnOrderKeepsClearOfTheRuleAboveIt) {
  Fabric fabric = openCloth();
  fabric.ends_per_cm = 20;
  fabric.warpSequence.assign(12, 0);  // a single stripe of 0.60 cm, and the repeat, which is as long
  const Boxes boxes = layOut(fabric);
  std::vector<double> bottoms;
  for (const Paper::Box& box : boxes)
    if (box.text == "0.60") bottoms.push_back(box.y + box.height);
  ASSERT_EQ(bottoms.size(), 2u);
  EXPECT_NEAR(bottoms[1] - bottoms[0], 4.2, 0.01);
}

/// One page is what a mill accepts: seventeen stripes are told by half of them, and pictures of colourways are smaller
/// before they ask for a page of their own.
TEST(ClothSheetPage, ATartanInFourColourwaysIsOnePage) {
  Fabric fabric = readFabric(LOOMLIGHT_SAMPLES "/cloths/tartan.json");
  for (const char* const name : {"Day", "Night", "Moor", "Shore"})
    fabric.colourways.push_back(colourwayOf(fabric, name));
  fabric.mill.reed_per_10cm = 48;
  fabric.mill.endsPerDent = {4};
  fabric.mill.selvedgeEnds = 16;
  fabric.mill.selvedgeWeave = "basket 2/2";
  const Boxes boxes = layOut(fabric);
  expectApart(boxes);
  EXPECT_EQ(boxes.back().page, 0);
  EXPECT_EQ(std::count_if(boxes.begin(), boxes.end(), [](const Paper::Box& box) { return box.text == "1.70"; }), 1)
      << "34 ends of 0.5 mm, on the way there alone";
  EXPECT_TRUE(says(boxes, "back from A 6 to B 20"));
}

TEST(ClothSheetPage, TellsTheStatesOfTheCloth) {
  Fabric fabric = openCloth();
  EXPECT_TRUE(says(layOut(fabric), "not said")) << "the reed";
  fabric.mill.reed_per_10cm = 19;
  fabric.mill.loomPicks_per_cm = 4.7;
  fabric.mill.selvedgeEnds = 12;
  fabric.warpSpacing = {1, 1, 2};
  const Boxes boxes = layOut(fabric);
  for (const char* const text : {"1 1 2, over each other, repeating", "19 dents/10 cm, ends per dent 2", "3.8", "4.7",
                                 "reed and denting; from crimp", "12 each side, 2 per dent"})
    EXPECT_TRUE(says(boxes, text)) << text;
}

TEST_F(ClothSheet, IsAPdfAndNothingElse) {
  EXPECT_THROW(writeClothSheet((folder_.path() / "sheet.txt").string(), openCloth(), {}, {}), InputError);
}

TEST_F(ClothSheet, WhatIsStoppedLeavesNoFile) {
  std::stop_source stopped;
  stopped.request_stop();
  Task task;
  task.stop = stopped.get_token();
  const std::string file = (folder_.path() / "sheet.pdf").string();
  EXPECT_FALSE(writeClothSheet(file, openCloth(), {}, task));
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace loomlight
