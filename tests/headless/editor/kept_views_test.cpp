/// Views that are kept: a strip of them, two compared, one brought back, one printed; and the denoised look at one.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/file.h"
#include "render/film/image.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"

namespace loomlight {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class KeptViews : public testing::Test {
 protected:
  KeptViews() : KeptViews(4) {}
  explicit KeptViews(int samples) : editor({960, 600, 1, samples}) {  // of few pixels, so that samples come soon
    Fabric cloth = smallCloth("First");
    cloth.drape.width_mm = cloth.drape.height_mm = 6;
    cloth.fibres[0].absorption_per_mm = Rgb(20, 6, 2);
    editor.start(cloth);
    editor.untilPictured();
  }
  void keepOne() {
    editor.key("k");
    editor.until("the view is kept", [&] { return editor.shows("snapshot.item_0"); });
  }
  /// The cloth as it was, and one of fewer ends.
  void keepTwo() {
    keepOne();
    editor.click("tab.cloth");
    editor.edits("the cloth is another one", [&] { editor.enter("cloth.ends_per_cm", "9"); });
    editor.untilPictured();
    editor.click("snapshot.keep");
    editor.until("the other one is kept too", [&] { return editor.shows("snapshot.item_1"); });
    untilKeptViewsRest();
  }
  /// The newest view is kept anew with every clearer picture, until that rests.
  void untilKeptViewsRest() {
    editor.until("the picture rests", [&] { return editor.fact("phase") == "converged"; });
    editor.frame();  // in which the last picture is taken
    editor.frame();  // in which it is shown in the strip
  }
  Pixels8 pictureIn(const std::string& widget) {
    const Pixels8* picture = nullptr;
    editor.until("a picture is in " + widget, [&] { return (picture = editor.pictureIn(widget)) != nullptr; });
    return *picture;
  }

  HeadlessEditor editor;
};

/// The picture goes on for longer than anybody needs to look at the kept one.
class KeptViewsOfALongPicture : public KeptViews {
 protected:
  KeptViewsOfALongPicture() : KeptViews(128) {}
};

TEST_F(KeptViewsOfALongPicture, ThePictureGetsBetterWithItsView) {
  EXPECT_FALSE(editor.shows("snapshot.item_0")) << "an empty strip takes room from the cloth";
  keepOne();
  const Pixels8 first = pictureIn("snapshot.item_0");
  EXPECT_GT(spreadOf(first).deviation, 0.03) << "the kept view is empty";
  editor.until("it is another picture", [&] { return pictureIn("snapshot.item_0").bytes != first.bytes; });
}

TEST_F(KeptViews, TwoAreCompared) {
  keepTwo();
  const std::vector<uint8_t> first = pictureIn("snapshot.item_0").bytes, second = pictureIn("snapshot.item_1").bytes;
  editor.click("snapshot.item_0");
  editor.click("snapshot.item_1");
  editor.click("snapshot.compare");
  editor.centre("compare.slider");
  // The first up to the line, the second beyond it.
  const auto expectLineAt = [&](float x) {
    const std::vector<HeadlessEditor::Drawn> drawn = editor.drawnIn("compare.picture");
    ASSERT_GE(drawn.size(), 2u);
    const HeadlessEditor::Drawn &left = drawn[drawn.size() - 2], &right = drawn.back();
    EXPECT_EQ(left.picture->bytes, first);
    EXPECT_EQ(right.picture->bytes, second);
    EXPECT_NEAR(left.place.x1, x, 1);
    EXPECT_NEAR(right.place.x0, x, 1);
  };
  const float middle = 0.5f * editor.screen().x;
  expectLineAt(middle);
  editor.dragWidget("compare.slider", 150);
  expectLineAt(middle + 150);
  editor.click("compare.way/Difference");
  const std::vector<uint8_t> difference = pictureIn("compare.picture").bytes;
  EXPECT_NE(difference, first);
  EXPECT_NE(difference, second);
  editor.click("compare.way/Side by side");
  editor.click("compare.close");
  editor.untilNoDialogIsOpen();
}

TEST_F(KeptViews, OneIsBroughtBack) {
  keepTwo();
  editor.click("snapshot.item_0");
  editor.edits("the first cloth is back", [&] { editor.click("snapshot.restore"); });
  EXPECT_THAT(editor.fact("cloth.per_inch"), StartsWith("51 "));
  editor.click("snapshot.remove");
  editor.until("a view is removed", [&] { return !editor.shows("snapshot.item_1"); });
  editor.key("ctrl+z");
  editor.until("undo takes it back", [&] { return editor.fact("cloth.per_inch").starts_with("23 "); });
}

/// So is the lamp that it is judged by; the cloth keeps its own.
TEST_F(KeptViews, AViewUnderAnotherLampComesBackUnderIt) {
  editor.key("j");
  editor.until("it is judged", [&] { return editor.fact("status.lamp") == "under F11"; });
  keepOne();
  for (int lamp = 0; lamp < 3; ++lamp) editor.key("j");
  editor.until("its own lamp shines", [&] { return !editor.shows("status.lamp"); });
  editor.click("snapshot.item_0");
  editor.edits("the view is back", [&] { editor.click("snapshot.restore"); });
  EXPECT_EQ(editor.fact("status.lamp"), "under F11");
  EXPECT_EQ(editor.saved().light.illuminant, StandardIlluminant::d65);
}

/// How the cloth is looked at is a part of the view.
TEST_F(KeptViews, FlatClothComesBackFlatAndDrapedClothDraped) {
  const auto restore = [&](const std::string& which) {
    editor.click(which);
    editor.edits("the cloth is back", [&] { editor.click("snapshot.restore"); });
  };
  const auto heightSeen = [&] {
    editor.key("ctrl+p");
    editor.centre("snapshot.close");
    const std::string said = editor.fact("snapshot.cloth");
    editor.click("snapshot.close");
    return said;
  };
  keepOne();  // draped
  editor.click("menu.view");
  editor.click("menu.flat");
  editor.click("menu.flat_repeats");
  editor.until("it lies flat", [&] { return editor.fact("flat").starts_with("Flat \u00b7 4 \u00d7 4 repeats"); });
  editor.wheelAt(editor.centre("viewport"), 2);
  const std::string said = editor.fact("flat"), seen = heightSeen();
  editor.untilPictured();
  editor.key("k");
  editor.until("the flat view is kept", [&] { return editor.shows("snapshot.item_1"); });

  restore("snapshot.item_0");
  editor.until("it is draped again", [&] { return editor.fact("flat").empty(); });
  EXPECT_NE(heightSeen(), seen);
  editor.click("snapshot.item_0");  // chosen no more
  restore("snapshot.item_1");
  editor.until("it lies flat again", [&] { return editor.fact("flat") == said; });
  EXPECT_EQ(heightSeen(), seen) << "from another distance";
}

TEST_F(KeptViews, TheBackComesBackFromBehind) {
  const auto turn = [&](const std::string& side) {
    editor.click("draft.back");
    editor.until("the " + side + " is seen", [&] { return editor.fact("draft.side") == side; });
    editor.untilPictured();
  };
  turn("back");
  keepOne();
  untilKeptViewsRest();
  const std::vector<uint8_t> kept = pictureIn("snapshot.item_0").bytes;
  turn("face");
  EXPECT_EQ(pictureIn("snapshot.item_0").bytes, kept) << "the picture of the face is none of the back";
  editor.click("snapshot.item_0");
  editor.click("snapshot.restore");
  editor.until("the back is seen again", [&] { return editor.fact("draft.side") == "back"; });
}

/// In light that is too strong the curve nears white, and the plain tone cuts off there. Kept views and snapshots are
/// as the cloth is shown, in either.
TEST_F(KeptViews, PicturesHaveTheToneThatIsShown) {
  editor.click("tab.scene");
  editor.edits("the light is strong", [&] { editor.enter("light.intensity", "8"); });
  editor.untilPictured();
  keepOne();
  const auto brightest = [](const Pixels8& picture) {
    return *std::max_element(picture.bytes.begin(), picture.bytes.end());
  };
  EXPECT_LT(brightest(pictureIn("snapshot.item_0")), 255);
  editor.click("menu.view");
  editor.click("menu.plain_tone");
  editor.key("k");
  editor.until("the plain view is kept", [&] { return editor.shows("snapshot.item_1"); });
  EXPECT_EQ(brightest(pictureIn("snapshot.item_1")), 255);
}

/// A better picture of flat cloth from elsewhere is none of the view that was kept.
TEST_F(KeptViewsOfALongPicture, AFlatViewKeepsItsPictureWhenTheCameraMoves) {
  editor.click("menu.view");
  editor.click("menu.flat");
  editor.click("menu.flat_repeat");
  editor.until("it lies flat", [&] { return editor.fact("flat").starts_with("Flat \u00b7 One repeat"); });
  editor.untilPictured();
  keepOne();
  const uint64_t generation = editor.number("generation"), first = editor.number("shown_samples");
  editor.wheelAt(editor.centre("viewport"), -6);
  editor.until("it is looked at from elsewhere", [&] { return editor.number("generation") > generation; });
  editor.untilPictured();
  const std::vector<uint8_t> kept = pictureIn("snapshot.item_0").bytes;
  const uint64_t much = 2 * std::max(first, editor.number("shown_samples"));  // when views are renewed
  editor.until("the other picture is much better", [&] { return editor.number("shown_samples") >= much; });
  EXPECT_EQ(pictureIn("snapshot.item_0").bytes, kept);
}

/// A print of 12 x 9 mm at 127 dpi is 60 x 45 pixels, and has a band below for bar and caption.
TEST_F(KeptViews, APrintHasItsSizeAndJoinsTheStrip) {
  editor.key("ctrl+p");
  editor.click("snapshot.size_in/Print, mm");
  for (const auto& [field, number] : {std::pair("width_mm", "12"), std::pair("height_mm", "9"), std::pair("dpi", "127"),
                                      std::pair("samples_per_pixel", "2")})
    editor.enter(fmt::format("snapshot.{}", field), number);
  editor.until("the pixels follow", [&] { return editor.fact("snapshot.pixels") == "60 \u00d7 45"; });
  editor.click("snapshot.scale_bar/On");
  editor.enter("snapshot.caption", "No. 7");
  const std::string file = editor.homeFile("print.png");
  editor.enter("snapshot.file", file);
  editor.click("snapshot.start");
  editor.until("the print is there", [&] { return editor.fact("snapshot.outcome").starts_with("Saved"); });
  const PictureExtent extent = readPngExtent(file);
  EXPECT_EQ(extent.width, 60);
  EXPECT_GT(extent.height, 45);
  EXPECT_LT(extent.height, 80);
  const std::string metres = {0, 0, 0x13, static_cast<char>(0x88)};  // 127 dpi are 5000 pixels a metre
  EXPECT_THAT(readFile(file, 1'000'000), HasSubstr("pHYs" + metres + metres + '\1'));
  editor.click("snapshot.close");
  editor.until("what is rendered to a file joins the strip", [&] { return editor.shows("snapshot.item_0"); });
}

TEST(Denoised, AKeyDenoisesAndAButtonShowsWhatWasTraced) {
  HeadlessEditor editor;
  editor.start(smallCloth("Noisy"));
  editor.until("the picture has samples", [&] { return editor.number("shown_samples") > 0; });
  EXPECT_EQ(editor.fact("denoised"), "no") << "noise is taken before anybody asked for it";
  editor.key("n");
  editor.until("the picture is denoised", [&] { return editor.fact("denoised") == "yes"; });
  editor.click("view.denoise");
  editor.until("the picture is as it was traced", [&] { return editor.fact("denoised") == "no"; });
}

}  // namespace
}  // namespace loomlight
