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
  controller_.beginFrame(false);
  sett(31);
  controller_.beginFrame(true);
  sett(32);
  EXPECT_EQ(controller_.fabric()->ends_per_cm, 32);
  controller_.beginFrame(false);
  sett(33);
  controller_.undo();
  EXPECT_EQ(controller_.fabric()->ends_per_cm, 32);
  controller_.undo();
  EXPECT_EQ(controller_.fabric()->ends_per_cm, before);
}

// A dye that was asked for comes after its gesture, while another may have begun.
TEST_F(DocumentControllerTest, ALateAnswerBelongsToTheGestureThatAskedForIt) {
  controller_.beginFrame(false);
  const uint64_t asked = controller_.gesture();
  sett(31);
  controller_.beginFrame(false);
  Fabric dyed = *controller_.fabric();
  dyed.fibres[0].absorption_per_mm *= 2.0f;
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
