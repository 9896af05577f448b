#include "app/editor/model/document.h"

#include <gtest/gtest.h>

#include <functional>

namespace loomlight {
namespace {

Fabric named(std::string name) {
  Fabric fabric;
  fabric.name = std::move(name);
  return fabric;
}

TEST(Document, OneGestureIsOneStepOfUndo) {
  Document document(named("first"));
  document.edit(named("a"), 7);
  document.edit(named("ab"), 7);
  document.edit(named("abc"), 7);
  document.edit(named("next"), 8);
  document.undo();
  EXPECT_EQ(document.fabric()->name, "abc");
  document.undo();
  EXPECT_EQ(document.fabric()->name, "first");
  EXPECT_FALSE(document.canUndo());
  document.redo();
  EXPECT_EQ(document.fabric()->name, "abc");
}

TEST(Document, AnEditAfterUndoForgetsWhatWasUndone) {
  Document document(named("first"));
  document.edit(named("a"), 1);
  document.undo();
  document.edit(named("b"), 1);
  EXPECT_FALSE(document.canRedo());
  document.undo();
  EXPECT_EQ(document.fabric()->name, "first");
}

/// Work that a killed editor left, say: a key too many must not lead back to something that nobody asks about.
TEST(Document, UnsavedWorkStaysUnsavedHoweverFarItIsUndone) {
  Document document = Document::unsaved(named("left"));
  EXPECT_TRUE(document.isDirty());
  EXPECT_NE(document.revision(), Document(named("left")).revision()) << "no copy of it would be kept";
  document.undo();
  EXPECT_EQ(document.fabric()->name, "left");
  document.edit(named("a"), 1);
  EXPECT_TRUE(document.isDirty());
  document.undo();
  EXPECT_EQ(document.fabric()->name, "left");
  EXPECT_TRUE(document.isDirty());
  document.savedAs("left.json", document.state());
  EXPECT_FALSE(document.isDirty());
}

TEST(Document, LookingAroundIsNoWorkAndSurvivesUndo) {
  Document document(named("first"));
  Camera camera;
  camera.azimuth_deg = 12;
  document.lookFrom(camera);
  EXPECT_FALSE(document.isDirty());
  EXPECT_FALSE(document.canUndo());
  document.edit(named("a"), 1);
  camera.azimuth_deg = 34;
  document.lookFrom(camera);
  document.undo();
  EXPECT_EQ(document.fabric()->name, "first");
  EXPECT_EQ(document.fabric()->camera.azimuth_deg, 34);
}

/// The size is that of pictures; how finely the cloth is laid is its own.
TEST(Document, TheSizeOfASnapshotSurvivesUndo) {
  Document document(named("first"));
  Fabric edited = named("a");
  edited.render.resolution = 2;
  document.edit(edited, 1);
  RenderSettings settings = edited.render;
  settings.width = 4000;
  settings.height = 3000;
  settings.samplesPerPixel = 7;
  document.renderAs(settings);
  document.undo();
  RenderSettings expected = named("first").render;
  expected.width = 4000;
  expected.height = 3000;
  expected.samplesPerPixel = 7;
  EXPECT_EQ(document.fabric()->name, "first");
  EXPECT_EQ(document.fabric()->render, expected);
  document.redo();
  EXPECT_EQ(document.fabric()->render, settings);
}

TEST(Document, JudgingByAnotherLampIsNoEditAndSurvivesUndo) {
  Document document(named("first"));
  document.judgeUnder(StandardIlluminant::f11);
  EXPECT_EQ(document.fabric()->light.illuminant, StandardIlluminant::f11);
  EXPECT_EQ(*document.cloth(), named("first"));
  EXPECT_FALSE(document.isDirty());
  EXPECT_FALSE(document.canUndo());
  Fabric edited = *document.fabric();
  edited.name = "a";
  edited.light.intensity = 2;
  document.edit(edited, 1);
  EXPECT_EQ(document.fabric()->light.illuminant, StandardIlluminant::f11) << "it is judged still";
  EXPECT_EQ(document.cloth()->light.illuminant, StandardIlluminant::d65);
  EXPECT_EQ(document.cloth()->light.intensity, 2);
  document.undo();
  EXPECT_EQ(*document.cloth(), named("first"));
  EXPECT_EQ(document.fabric()->light.illuminant, StandardIlluminant::f11);
  document.judgeUnder(std::nullopt);
  EXPECT_EQ(document.fabric(), document.cloth());
}

/// A lamp with a tint of its own has it back.
TEST(Document, AClothThatIsJudgedKeepsTheLampItHas) {
  Fabric warm = named("warm");
  warm.light.illuminant = StandardIlluminant::blackBody;
  warm.light.temperature_K = 3000;
  Document document(warm);
  document.judgeUnder(StandardIlluminant::a);
  Fabric edited = *document.fabric();
  edited.name = "a";
  document.edit(edited, 1);
  EXPECT_EQ(document.cloth()->light, warm.light);
}

TEST(Document, AThirdLampIsTheClothsAndItsOwnEndsJudging) {
  Document document(named("first"));
  const auto chosen = [&](StandardIlluminant lamp) {
    Fabric fabric = *document.fabric();
    fabric.light.illuminant = lamp;
    return fabric;
  };
  document.judgeUnder(StandardIlluminant::f11);
  document.edit(chosen(StandardIlluminant::d65), 1);
  EXPECT_FALSE(document.judgedUnder());
  EXPECT_FALSE(document.canUndo()) << "it had that lamp before";
  EXPECT_EQ(document.fabric()->light.illuminant, StandardIlluminant::d65);
  document.judgeUnder(StandardIlluminant::f11);
  document.edit(chosen(StandardIlluminant::d50), 2);
  EXPECT_FALSE(document.judgedUnder());
  EXPECT_EQ(document.cloth()->light.illuminant, StandardIlluminant::d50);
  document.undo();
  EXPECT_EQ(document.cloth()->light.illuminant, StandardIlluminant::d65);
}

/// What is made of the cloth as it is kept is as good.
TEST(Document, AnEditThatKnowsNothingOfTheLampGoesOnBeingJudged) {
  Document document(named("first"));
  document.judgeUnder(StandardIlluminant::a);
  document.edit(named("a"), 1);
  EXPECT_EQ(document.judgedUnder(), StandardIlluminant::a);
  EXPECT_EQ(*document.cloth(), named("a"));
  EXPECT_EQ(document.fabric()->light.illuminant, StandardIlluminant::a);
  Camera camera;
  camera.azimuth_deg = 12;
  document.lookFrom(camera);
  EXPECT_EQ(document.fabric()->camera, camera);
  EXPECT_EQ(document.fabric()->light.illuminant, StandardIlluminant::a);
}

TEST(Document, UndoToWhatWasSavedIsNotDirty) {
  Document document(named("first"));
  document.edit(named("a"), 1);
  EXPECT_TRUE(document.isDirty());
  document.savedAs("a.json", document.state());
  EXPECT_FALSE(document.isDirty());
  EXPECT_EQ(document.file(), "a.json");
  document.edit(named("b"), 1);
  EXPECT_TRUE(document.isDirty());
  document.undo();
  EXPECT_FALSE(document.isDirty());
  EXPECT_EQ(document.fabric()->name, "a");
}

TEST(Document, WhatIsEditedWhileItIsSavedIsNotSaved) {
  Document document(named("first"));
  document.edit(named("a"), 1);
  const uint64_t writing = document.state();
  document.edit(named("b"), 1);
  document.savedAs("a.json", writing);
  EXPECT_TRUE(document.isDirty());
  document.edit(named("c"), 2);
  document.undo();
  EXPECT_EQ(document.fabric()->name, "b");
  EXPECT_TRUE(document.isDirty());
}

TEST(Document, SmallStepsAreUndoneWithoutEnd) {
  Document document(named("first"));
  for (int i = 1; i <= 20'000; ++i) document.edit(named(std::to_string(i)), static_cast<uint64_t>(i));
  for (int i = 0; i < 20'000; ++i) document.undo();
  EXPECT_EQ(document.fabric()->name, "first");
}

TEST(Document, LargeStepsAreForgottenBeforeMemoryIsFull) {
  constexpr int kSide = 1000, kRoomFor = 5, kEdits = 20;
  Fabric fabric;
  const auto all = [](uint8_t value) { return Weave(std::vector<Weave::Row>(kSide, Weave::Row(kSide, value))); };
  fabric.weave = all(0);
  Document document(fabric, {}, size_t{kRoomFor} * kSide * kSide);
  for (int i = 1; i <= kEdits; ++i) {
    fabric.weave = all(static_cast<uint8_t>(i % 2));
    document.edit(fabric, static_cast<uint64_t>(i));
  }
  int steps = 0;
  for (; document.canUndo(); document.undo()) ++steps;
  EXPECT_GE(steps, kRoomFor - 2);
  EXPECT_LT(steps, kRoomFor);
  EXPECT_TRUE(document.isDirty()) << "what is in the file is not among them any more";

  Document cells(fabric, {}, size_t{kRoomFor} * kSide * kSide);
  for (int i = 1; i <= kEdits; ++i) {
    fabric.weave = fabric.weave.with(i, i, i % 3 == 0);
    cells.edit(fabric, static_cast<uint64_t>(i));
  }
  for (int i = 0; i < kEdits; ++i) cells.undo();
  EXPECT_FALSE(cells.isDirty()) << "single crossings share all other picks";
}

TEST(Document, EverythingLongThatAFabricHoldsTakesMemory) {
  constexpr size_t kLong = 100'000, kRoomFor = 5;
  constexpr int kEdits = 20;
  const std::vector<std::function<void(Fabric&)>> lengthen = {
      [](Fabric& fabric) { fabric.warpSequence.assign(kLong, 0); },
      [](Fabric& fabric) { fabric.weftSequence.assign(kLong, 0); },
      [](Fabric& fabric) { fabric.description.assign(4 * kLong, 'a'); },
      [](Fabric& fabric) { fabric.drape.file.assign(4 * kLong, 'a'); },
      [](Fabric& fabric) { fabric.yarns[0].name.assign(4 * kLong, 'a'); },
      [](Fabric& fabric) { fabric.colourways.assign(4 * kLong / sizeof(Colourway), Colourway{}); }};
  for (size_t kind = 0; kind < lengthen.size(); ++kind) {
    Fabric fabric;
    lengthen[kind](fabric);
    Document document(fabric, {}, kRoomFor * 4 * kLong);
    for (int i = 1; i <= kEdits; ++i) document.edit(fabric, static_cast<uint64_t>(i));
    size_t steps = 0;
    for (; document.canUndo(); document.undo()) ++steps;
    EXPECT_GE(steps, kRoomFor - 3) << kind;
    EXPECT_LT(steps, kRoomFor) << kind;
  }
}

TEST(Document, UndoLeavesMostOfTheMachinesMemoryAlone) {
  constexpr uint64_t kMiB = uint64_t{1} << 20;
  EXPECT_EQ(Document::memoryForUndo_bytes(512 * kMiB), 64 * kMiB);
  EXPECT_EQ(Document::memoryForUndo_bytes(4096 * kMiB), 512 * kMiB);
  EXPECT_EQ(Document::memoryForUndo_bytes(8192 * kMiB), 1024 * kMiB);
  EXPECT_EQ(Document::memoryForUndo_bytes(65536 * kMiB), 1024 * kMiB);
}

TEST(Document, UndoAndRedoSayWhereTheEditWasMade) {
  Document document{Fabric{}};
  const EditPlace draft{EditPlace::Panel::draft, 12, 3, 4, 0, 0}, page{EditPlace::Panel::inspector, 0, 0, 0, 2, 1};
  Fabric fabric;
  fabric.name = "one";
  document.edit(fabric, 1, draft);
  fabric.name = "two";
  document.edit(fabric, 1, page);  // one gesture is where it began
  fabric.name = "three";
  document.edit(fabric, 2, page);
  EXPECT_EQ(document.undo(), page);
  EXPECT_EQ(document.undo(), draft);
  EXPECT_EQ(document.undo(), EditPlace{});
  EXPECT_EQ(document.redo(), draft);
  EXPECT_EQ(document.redo(), page);
}

}  // namespace
}  // namespace loomlight
