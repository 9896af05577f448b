#include "app/editor/document.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/error.h"

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

TEST(Document, UndoToWhatWasSavedIsNotDirty) {
  const std::string file = testing::TempDir() + "/document-test-" + std::to_string(getpid()) + ".json";
  Document document(named("first"));
  document.edit(named("a"), 1);
  EXPECT_TRUE(document.isDirty());
  document.save(file);
  EXPECT_FALSE(document.isDirty());
  document.edit(named("b"), 1);
  EXPECT_TRUE(document.isDirty());
  document.undo();
  EXPECT_FALSE(document.isDirty());
  EXPECT_EQ(document.fabric()->name, "a");
}

TEST(Document, ASaveThatFailsChangesNothing) {
  Document document(named("first"), "old.json");
  document.edit(named("a"), 1);
  EXPECT_THROW(document.save(testing::TempDir() + "/no such folder/x.json"), InputError);
  EXPECT_TRUE(document.isDirty());
  EXPECT_EQ(document.file(), "old.json");
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
