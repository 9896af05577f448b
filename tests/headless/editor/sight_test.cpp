/// How the cloth is looked at: as large as it is, flat, from behind; its floats one by one; a tile and what it is
/// large.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/yarn/derived.h"
#include "tests/headless/editor/weaver.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class Sight : public testing::Test {
 protected:
  Sight() { editor.start(smallTwill()); }
  void view(const std::string& item) {
    editor.click("menu.view");
    editor.click(item);
  }
  /// Millimetres of cloth on a millimetre of a display of 96 pixels to the inch.
  double scale() {
    const Camera camera = editor.saved().camera;
    const HeadlessEditor::Rect r = editor.rect("viewport");
    const double seen_mm = 2 * camera.distance_mm * std::tan(camera.fov_deg * kPi / 360);
    return seen_mm / ((r.y1 - r.y0) / (96 / 25.4));
  }
  /// A drape is fitted when its size is known, which may be after its picture.
  void untilFitted() {
    editor.until("the drape is fitted", [&] { return editor.fact("fit") == "done"; });
  }
  HeadlessEditor editor{{1280, 900, 1}};
  Weaver weaver{editor};
};

TEST_F(Sight, ActualSizeIsActualAndStraightFromAbove) {
  editor.key("ctrl+1");
  EXPECT_NEAR(scale(), 1, 1e-3);
  EXPECT_EQ(editor.saved().camera.elevation_deg, 90);
  editor.key("ctrl+0");
  EXPECT_LT(scale(), 0.5) << "a piece of 4 mm fills the window";
}

/// As in programs for pictures: with Space held a drag moves what is looked at, and neither turns the cloth nor draws.
TEST_F(Sight, SpaceMovesWhatIsLookedAt) {
  const auto drag = [&](ImVec2 from) { editor.drag(from, ImVec2(from.x + 30, from.y - 20)); };
  const ImVec2 middle = editor.centre("viewport");
  const Fabric before = editor.saved();
  editor.hold("space");
  drag(middle);
  drag(weaver.crossing(0, 0));
  editor.let("space");
  const Camera panned = editor.savedAs(editor.homeFile("panned.json")).camera;
  EXPECT_EQ(editor.fact("dirty"), "no");
  EXPECT_EQ(weaver.rows(), rowsOf(before.weave));
  EXPECT_EQ(panned.azimuth_deg, before.camera.azimuth_deg);
  EXPECT_NE(panned.target_mm, before.camera.target_mm);
  drag(middle);
  EXPECT_NE(editor.savedAs(editor.homeFile("turned.json")).camera.azimuth_deg, panned.azimuth_deg);
}

/// A ruler reads 25 mm of what is believed to be 50: the display is twice as fine.
TEST_F(Sight, ARulerCorrectsActualSize) {
  editor.click("menu.edit");
  editor.click("menu.preferences");
  editor.enter("preferences.ruler", "25");
  editor.click("preferences.close");
  editor.key("ctrl+1");
  EXPECT_NEAR(scale(), 0.5, 1e-3);
}

/// Flat cloth is a view: neither the drape nor its camera is another one, and there is nothing to undo or to save.
TEST_F(Sight, SoManyRepeatsOrCentimetresLieFlatAndAreNoEdit) {
  const Fabric draped = editor.saved();
  const auto flatly = [&](const std::string& item, const std::string& said) {
    const uint64_t generation = editor.number("generation");
    view("menu.flat");
    editor.click(item);
    editor.until(item, [&] { return editor.fact("flat").starts_with(said); });
    editor.until("it is pictured", [&] { return editor.number("generation") > generation; });
    editor.untilPictured();
    EXPECT_EQ(editor.fact("error"), "");
  };
  flatly("menu.flat_repeats", "Flat \u00b7 4 \u00d7 4 repeats");
  const double width_mm = 4.0 * static_cast<double>(patternEnds(draped)) * draped.warpPitch_mm();
  EXPECT_THAT(editor.fact("flat"), HasSubstr(fmt::format("{:.1f}", width_mm)));
  flatly("menu.flat_cm", "Flat \u00b7 10 \u00d7 10 cm");
  editor.wheelAt(editor.centre("viewport"), 2);
  EXPECT_EQ(editor.fact("dirty"), "no");
  editor.key("ctrl+z");  // takes nothing back
  const Fabric saved = editor.savedAs(editor.homeFile("still draped.json"));
  EXPECT_EQ(saved.drape, draped.drape);
  EXPECT_EQ(saved.camera, draped.camera);
}

TEST_F(Sight, FlatClothOfAnyNumberOfRepeats) {
  view("menu.flat");
  editor.enter("menu.flat_count", "7");
  editor.until("seven repeats", [&] { return editor.fact("flat").starts_with("Flat \u00b7 7 \u00d7 7 repeats"); });
  editor.key("Escape");
  editor.until("the menu is shut", [&] { return !editor.shows("menu.flat_count"); });
  editor.key("Escape");
  editor.until("Esc looks at the drape again", [&] { return editor.fact("flat").empty(); });
}

/// An edit shows on the flat cloth, and keeps the drape; another drape is looked at.
TEST_F(Sight, FlatClothIsEditedLikeAnyOther) {
  view("menu.flat");
  editor.click("menu.flat_repeat");
  const Fabric draped = editor.saved();
  editor.edits("a crossing", [&] { editor.clickAt(weaver.crossing(0, 0)); });
  EXPECT_TRUE(editor.fact("flat").starts_with("Flat \u00b7 One repeat"));
  EXPECT_EQ(editor.saved().drape, draped.drape);
  editor.edits("another drape", [&] { editor.choose("view.drape", "Cylinder"); });
  EXPECT_EQ(editor.fact("flat"), "");
  EXPECT_EQ(editor.saved().drape.kind, DrapeKind::cylinder);
}

/// A repeat of another sett is of another size: what is said, seen and rendered are the same.
TEST_F(Sight, FlatRepeatsFollowTheCloth) {
  view("menu.flat");
  editor.click("menu.flat_repeat");
  editor.click("tab.cloth");
  editor.edits("half as dense", [&] { editor.enter("cloth.ends_per_cm", "10"); });
  editor.edits("and the other way", [&] { editor.enter("cloth.picks_per_cm", "10"); });
  const Fabric cloth = editor.saved();
  const glm::dvec2 piece_mm = pieceOf(cloth, {true, 1}).size_mm;
  const std::string size = fmt::format("{:.1f} \u00d7 {:.1f} mm", piece_mm.x, piece_mm.y);
  EXPECT_THAT(editor.fact("flat"), EndsWith(size));
  editor.key("ctrl+p");
  editor.click("snapshot.scale/Whole piece");
  editor.until("a snapshot shows as much", [&] { return editor.fact("snapshot.cloth") == size; });
  editor.key("Escape");
}

/// It fills the window as it does when it is fitted by hand, whatever was seen before.
TEST_F(Sight, AnotherDrapeIsFitted) {
  for (const char* const drape : {"Folds", "Cushion", "Cylinder", "Skirt", "Flat"}) {
    editor.edits(drape, [&] { editor.choose("view.drape", drape); });
    untilFitted();
    const Camera chosen = editor.saved().camera;
    editor.key("f");
    editor.frame();
    EXPECT_EQ(editor.saved().camera, chosen) << drape;
  }
}

/// And from where it was looked at before the cloth lay flat.
TEST_F(Sight, ADrapeThatIsChosenOfFlatClothIsSeenFromWhereItWas) {
  const Camera before = editor.saved().camera;
  for (const char* const drape : {"Cylinder", "Folds"}) {
    view("menu.flat");
    editor.click("menu.flat_repeat");
    editor.edits(drape, [&] { editor.choose("view.drape", drape); });
    untilFitted();
    const Camera chosen = editor.saved().camera;
    EXPECT_EQ(chosen.elevation_deg, before.elevation_deg) << drape;
    EXPECT_EQ(chosen.azimuth_deg, before.azimuth_deg) << drape;
  }
}

/// A snapshot of flat cloth shows as much of it as it says.
TEST_F(Sight, ASnapshotOfFlatClothSaysHowMuchItShows) {
  view("menu.flat");
  editor.click("menu.flat_cm");
  editor.key("ctrl+p");
  const HeadlessEditor::Rect r = editor.rect("viewport");
  const std::string high = fmt::format("{:.1f} mm", 100 * std::max(1.0f, (r.y1 - r.y0) / (r.x1 - r.x0)));
  editor.until("all ten centimetres are seen", [&] { return editor.fact("snapshot.cloth").ends_with(high); });
  editor.key("Escape");
}

/// Or it shows the piece and nothing beside it: its picture has the proportions of the cloth.
TEST_F(Sight, ASnapshotShowsTheWholePieceAndNoMore) {
  view("menu.flat");
  editor.click("menu.flat_cm");
  editor.key("ctrl+p");
  editor.enter("snapshot.width", "321");
  editor.click("snapshot.scale/Whole piece");
  editor.until("it is ten by ten centimetres",
               [&] { return editor.fact("snapshot.cloth") == "100.0 \u00d7 100.0 mm"; });
  editor.key("Escape");
  editor.until("the dialog is shut", [&] { return !editor.shows("snapshot.close"); });
  EXPECT_EQ(editor.saved().render.width, 321);
  EXPECT_EQ(editor.saved().render.height, 321);
}

/// Stripes that go one way are a square piece too, not a ribbon.
TEST_F(Sight, RepeatsOfStripesAreAsManyAsMakeASquare) {
  Fabric striped = editor.saved();
  striped.warpSequence.assign(48, 0);
  std::fill_n(striped.warpSequence.begin(), 24, 1);
  const FlatPiece piece = pieceOf(striped, {true, 1});
  EXPECT_EQ(piece.repeats.x, 1);
  EXPECT_GT(piece.repeats.y, 1);
  EXPECT_NEAR(piece.size_mm.y / piece.size_mm.x, 1, 0.5 / piece.repeats.y) << "to half a repeat";
}

/// The lamps of a light booth, one after the other. The cloth is looked at and not edited: what is saved, and handed
/// over, has its own lamp.
TEST_F(Sight, JTakesTheNextLampOfTheBoothAndEditsNothing) {
  editor.untilPictured();
  EXPECT_FALSE(editor.shows("status.lamp")) << "daylight goes without saying";
  const Fabric cloth = editor.saved();
  for (const char* const lamp : {"under F11", "under A", "under LED-B3", ""}) {
    const uint64_t generation = editor.number("generation");
    editor.key("j");
    editor.until("the cloth is pictured anew", [&] { return editor.number("generation") > generation; });
    EXPECT_EQ(editor.shows("status.lamp") ? editor.fact("status.lamp") : "", lamp);
    EXPECT_EQ(editor.fact("dirty"), "no");
    EXPECT_EQ(editor.savedAs(editor.homeFile(fmt::format("judged {}.json", lamp))), cloth);
    editor.untilPictured();
  }
}

/// The page of the scene shows the lamp by which the cloth is seen, and says which it keeps; one that is chosen there
/// is the cloth's.
TEST_F(Sight, ThePageOfTheSceneSaysWhichLampIsOnlyToJudge) {
  editor.click("tab.scene");
  EXPECT_FALSE(editor.shows("light.own_lamp"));
  editor.key("j");
  editor.until("it says so", [&] { return editor.shows("light.own_lamp"); });
  EXPECT_EQ(editor.fact("light.illuminant"), "F11, shop (TL84)");
  editor.edits("half the light", [&] { editor.enter("light.intensity", "0.5"); });
  EXPECT_TRUE(editor.shows("light.own_lamp")) << "another number of the light leaves the lamp alone";
  EXPECT_EQ(editor.saved().light.illuminant, StandardIlluminant::d65);
  editor.choose("light.illuminant", "D65, daylight");
  editor.until("its own lamp ends judging", [&] { return !editor.shows("light.own_lamp"); });
  EXPECT_EQ(editor.fact("dirty"), "no");
  editor.key("j");
  editor.edits("a lamp of its own", [&] { editor.choose("light.illuminant", "D50, print booth"); });
  EXPECT_FALSE(editor.shows("light.own_lamp"));
  EXPECT_EQ(editor.saved().light.illuminant, StandardIlluminant::d50);
}

TEST_F(Sight, ThePlainToneIsAViewAndIsRemembered) {
  const auto waysAre = [&](const std::string& ways) {
    editor.until("it is shown: " + ways, [&] { return editor.fact("view.ways") == ways; });
  };
  const std::string file = editor.fact("file");
  view("menu.plain_tone");
  waysAre("Plain tone");
  EXPECT_EQ(editor.fact("view.exposure"), "0 EV");
  EXPECT_EQ(editor.fact("dirty"), "no");
  editor.leave();
  editor.startOn(file);
  waysAre("Plain tone");
  view("menu.plain_tone");
  waysAre("");
}

/// Without a printer it is what sRGB has not that is marked.
TEST_F(Sight, TheGamutWarningNeedsNoPrinter) {
  for (const char* const ways : {"Gamut warning", ""}) {
    editor.key("shift+y");
    editor.until("the picture says so", [&] { return editor.fact("view.ways") == ways; });
  }
}

/// The spectrum of a lamp, as text of two columns; its name's ending is that of a draft as well, or of nothing.
TEST_F(Sight, ALampThatIsDroppedShinesOnTheCloth) {
  for (const char* name : {"tube.txt", "tube.spd"}) {
    const std::string lamp = editor.homeFile(name);
    test::putBytes(lamp, "nm power\n380 1\n540 1\n550 9\n560 1\n730 1\n");
    editor.edits("it is the cloth's lamp", [&] { editor.drop(lamp); });
    const Light light = editor.saved().light;
    EXPECT_EQ(light.illuminant, StandardIlluminant::file);
    EXPECT_EQ(light.illuminantFile, lamp);
    EXPECT_EQ(light.kind, smallTwill().light.kind) << "where light comes from is another matter";
    editor.untilPictured();
    EXPECT_EQ(editor.fact("error"), "");
    EXPECT_EQ(editor.fact("status.lamp"), "under a measured lamp");
  }
  editor.edits("one step takes it back", [&] { editor.key("ctrl+z"); });
  editor.edits("and the other", [&] { editor.key("ctrl+z"); });
  EXPECT_EQ(editor.saved().light.illuminant, StandardIlluminant::d65);
}

TEST_F(Sight, ALampThatIsBrokenIsSaidAndChangesNothing) {
  const std::string lamp = editor.homeFile("broken.txt");
  test::putBytes(lamp, "380 1\n480 -1\n730 1\n");
  editor.drop(lamp);
  editor.until("it is said", [&] { return editor.shows("message.answer_0"); });
  EXPECT_THAT(editor.fact("message"), HasSubstr("line 2: expected a power of 0 or more"));
  editor.answer();
  EXPECT_EQ(editor.fact("dirty"), "no");
}

/// With the draft the cloth is turned over: what is under the mouse is the same crossing, seen from behind.
TEST_F(Sight, BackTurnsTheClothToo) {
  editor.key("1");
  editor.untilPictured();
  const uint64_t generation = editor.number("generation");
  const Rows before = weaver.rows();
  editor.click("draft.back");
  editor.until("the cloth is pictured anew", [&] { return editor.number("generation") > generation; });
  editor.untilPictured();
  EXPECT_EQ(editor.fact("error"), "");
  EXPECT_EQ(weaver.rows(), before) << "looking from behind has edited the cloth";
  EXPECT_EQ(editor.fact("dirty"), "no");
  editor.click("draft.back");
  editor.untilPictured();
}

TEST_F(Sight, FloatsAreListedAndGoneThrough) {
  weaver.takes("Satin 8");
  editor.click("draft.floats");
  editor.enter("draft.long_float", "1");
  const double pitch_mm = std::max(smallTwill().warpPitch_mm(), smallTwill().weftPitch_mm());
  ASSERT_GT(7 * pitch_mm, 1);
  editor.until("eight warp floats and eight weft floats are counted",
               [&] { return editor.fact("draft.floats_shown") == "16 floats"; });
  editor.click("draft.float_next");
  editor.until("the first is looked at", [&] { return editor.fact("draft.floats_shown") == "1 of 16"; });
  editor.click("draft.float_before");
  editor.until("the last is looked at", [&] { return editor.fact("draft.floats_shown") == "16 of 16"; });
  EXPECT_THAT(editor.fact("draft.said"), HasSubstr("float, "));
  editor.enter("draft.long_float", "9");
  editor.until("none is longer", [&] { return editor.fact("draft.floats_shown") == "none"; });
  editor.until("the one that is long no more is told of no more",
               [&] { return editor.fact("draft.said") == "marked: floats longer than 9.0 mm"; });
}

/// One definition: what the status says, what is marked and what is listed. A thread that nothing binds is marked, so
/// it cannot be that nothing is long.
TEST_F(Sight, AThreadThatNothingBindsFloatsWithoutEnd) {
  editor.until("the figures are known", [&] { return editor.fact("status.float").starts_with("longest float 2"); });
  editor.click("draft.floats");
  editor.enter("draft.long_float", "9");
  for (int pick = 0; pick < 4; ++pick)
    if (weaver.rows()[static_cast<size_t>(3 - pick)][0] != '#')
      editor.edits("warp over", [&] { editor.clickAt(weaver.crossing(pick, 0)); });
  editor.until("it is said", [&] { return editor.fact("status.float") == "endless float, 1 over 9.0 mm"; });
  editor.until("it is listed", [&] { return editor.fact("draft.floats_shown") == "1 float"; });
}

TEST_F(Sight, ATileSaysHowLargeItIsAndWhenItHasTooFewPixels) {
  editor.click("menu.file");
  editor.click("menu.export");
  editor.click("menu.export_tile");
  editor.until("its size is known", [&] { return editor.fact("tile.size_mm").ends_with("mm"); });
  editor.click("tile.twist/Off");
  editor.until("weave and colours alone", [&] { return editor.fact("tile.repeats") == "1 \u00d7 1"; });
  EXPECT_EQ(editor.fact("tile.few_pixels"), "no");
  EXPECT_GE(std::stod(editor.fact("tile.per_thread")), 16);
  editor.enter("tile.size", "16");
  editor.until("four pixels a thread are few", [&] { return editor.fact("tile.few_pixels") == "yes"; });
  EXPECT_EQ(editor.fact("dirty"), "no") << "a tile is no edit of the cloth";
}

TEST_F(Sight, ASnapshotSaysHowMuchClothItShows) {
  editor.key("ctrl+p");
  editor.click("snapshot.size_in/Print, mm");
  editor.enter("snapshot.width_mm", "60");
  editor.enter("snapshot.height_mm", "40");
  editor.click("snapshot.scale/1 : 1");
  editor.until("as much cloth as paper", [&] {
    return editor.fact("snapshot.cloth").starts_with("60.") && editor.fact("snapshot.cloth").ends_with("40.0 mm");
  });
  editor.click("snapshot.scale/As seen");
}

TEST_F(Sight, AnotherYarnToPaintWith) {
  EXPECT_EQ(editor.fact("yarn"), "0");
  editor.character("]");
  editor.until("the next yarn", [&] { return editor.fact("yarn") == "1"; });
  editor.key("x");
  editor.until("the one before", [&] { return editor.fact("yarn") == "0"; });
  editor.character("[");
  editor.until("round to the last", [&] { return editor.fact("yarn") == "1"; });
}

}  // namespace
}  // namespace loomlight
