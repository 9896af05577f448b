#include "app/editor/controllers/document_controller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/editor/model/sample_fabric.h"

namespace loomlight {
namespace {

class DocumentControllerTest : public testing::Test {
 protected:
  DocumentControllerTest() { setenv("XDG_STATE_HOME", folder_.c_str(), 1); }
  ~DocumentControllerTest() override {
    controller_.endWell();
    unsetenv("XDG_STATE_HOME");
    std::filesystem::remove_all(folder_);
  }
  void sett(double ends_per_cm, const EditPlace& place = {}) {
    Fabric fabric = *controller_.fabric();
    fabric.ends_per_cm = ends_per_cm;
    controller_.edit(std::move(fabric), place);
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("loomlight-document-" + std::to_string(getpid()));
  DocumentController controller_{(setenv("XDG_STATE_HOME", folder_.c_str(), 1), Document(sampleFabric())), {}};
};

TEST_F(DocumentControllerTest, AGestureIsOneStepOfUndo) {
  const double before = controller_.fabric()->ends_per_cm;
  controller_.beginFrame({});
  sett(31);
  controller_.beginFrame({true});
  sett(32);
  EXPECT_EQ(controller_.fabric()->ends_per_cm, 32);
  controller_.beginFrame({});
  sett(33);
  controller_.undo();
  EXPECT_EQ(controller_.fabric()->ends_per_cm, 32);
  controller_.undo();
  EXPECT_EQ(controller_.fabric()->ends_per_cm, before);
}

// Tab goes from one field to the next, and nothing is let go between.
TEST_F(DocumentControllerTest, AnotherFieldIsAnotherGesture) {
  constexpr uint32_t kName = 7, kEnds = 8;
  controller_.beginFrame({true, false, kName});
  sett(31);
  controller_.beginFrame({true, false, kName});
  sett(32);
  controller_.beginFrame({true, false, kEnds});
  sett(33);
  controller_.undo();
  EXPECT_EQ(controller_.fabric()->ends_per_cm, 32);
  controller_.undo();
  EXPECT_FALSE(controller_.document().canUndo()) << "what was typed in one field is one step";
}

// A click in one panel takes what was typed in another.
TEST_F(DocumentControllerTest, TwoPanelsInOneFrameAreTwoGestures) {
  controller_.beginFrame({});
  sett(31, {EditPlace::Panel::draft});
  sett(32, {EditPlace::Panel::inspector});
  controller_.undo();
  EXPECT_EQ(controller_.fabric()->ends_per_cm, 31);
}

TEST_F(DocumentControllerTest, HowPicturesAreRenderedIsNoEdit) {
  RenderSettings settings = controller_.fabric()->render;
  settings.width = 123;
  controller_.renderAs(settings);
  EXPECT_EQ(controller_.fabric()->render.width, 123);
  EXPECT_FALSE(controller_.document().isDirty());
  EXPECT_FALSE(controller_.document().canUndo());
}

// A dye that was asked for comes after its gesture, while another may have begun.
TEST_F(DocumentControllerTest, ALateAnswerBelongsToTheGestureThatAskedForIt) {
  controller_.beginFrame({});
  const uint64_t asked = controller_.gesture();
  sett(31);
  controller_.beginFrame({});
  Fabric dyed = *controller_.fabric();
  dyed.fibres[0].absorption_per_mm.primaries *= 2.0f;
  controller_.edit(dyed, {}, asked);
  controller_.undo();
  EXPECT_NE(controller_.fabric()->ends_per_cm, 31) << "both are taken back";
  EXPECT_FALSE(controller_.document().canUndo());
}

TEST_F(DocumentControllerTest, WhatIsNoClothIsRefusedAndSaid) {
  const auto before = controller_.fabric();
  sett(-1);
  EXPECT_EQ(controller_.fabric(), before);
  EXPECT_THAT(controller_.refusal(), testing::HasSubstr("ends_per_cm"));
  sett(20);
  EXPECT_EQ(controller_.refusal(), "");
}

TEST_F(DocumentControllerTest, UndoTellsWhereTheEditWasMade) {
  EditPlace place{EditPlace::Panel::inspector, 0, 0, 0, 2, 1};
  sett(31, place);
  EXPECT_EQ(controller_.undo(), place);
}

}  // namespace
}  // namespace loomlight
