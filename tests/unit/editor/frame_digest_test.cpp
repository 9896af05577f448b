#include "app/editor/display/frame_digest.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "app/editor/display/texture_id.h"
#include "tests/support/windowless_ui.h"

namespace loomlight {
namespace {

/// A page with a text, a picture and a strip of a colour.
struct Page {
  std::string text = "12 samples";
  uint32_t picture = 7;
  ImVec4 colour{0.2f, 0.4f, 0.6f, 1};
  float width = 300;
};

class FrameDigest : public testing::Test {
 protected:
  uint64_t of(const Page& page) {
    ui_.frame(Theme::dark(), [&](Ui&) {
      ImGui::SetNextWindowPos(ImVec2(0, 0));
      ImGui::SetNextWindowSize(ImVec2(page.width, 200));
      ImGui::Begin("page", nullptr, ImGuiWindowFlags_NoDecoration);
      ImGui::TextUnformatted(page.text.c_str());
      ImGui::Image(textureId(page.picture), ImVec2(40, 30));
      ImGui::ColorButton("strip", page.colour);
      ImGui::End();
    });
    return digestOf(*ImGui::GetDrawData());
  }

 private:
  test::WindowlessUi ui_{ImVec2(400, 300)};
};

TEST_F(FrameDigest, IsTheSameWhileAllLooksTheSame) {
  of({});
  const uint64_t first = of({});  // a window is placed in its first frame
  EXPECT_EQ(of({}), first);
  EXPECT_EQ(of({}), first);
}

TEST_F(FrameDigest, IsAnotherWhateverIsSeenToChange) {
  of({});
  const uint64_t before = of({});
  Page text, picture, colour, width;
  text.text = "13 samples";
  picture.picture = 8;
  colour.colour.x = 0.21f;
  width.width = 301;
  for (const Page& other : {text, picture, colour, width}) {
    EXPECT_NE(of(other), before);
    EXPECT_EQ(of({}), before) << "and the same again once it looks so";
  }
}

// Whatever else may have changed with it.
TEST_F(FrameDigest, KnowsEachPartOfAFrameByItself) {
  of({});
  ImDrawData& frame = *ImGui::GetDrawData();
  const uint64_t before = digestOf(frame);
  ImDrawList& list = *frame.CmdLists[frame.CmdListsCount - 1];
  ImDrawCmd& command = list.CmdBuffer[0];
  const auto expectKnown = [&](const char* what, auto& part, auto other) {
    const auto kept = std::exchange(part, other);
    EXPECT_NE(digestOf(frame), before) << what;
    part = kept;
  };
  expectKnown("where the display is", frame.DisplayPos.x, 1.0f);
  expectKnown("its size", frame.DisplaySize.y, 301.0f);
  expectKnown("pixels to a unit", frame.FramebufferScale.x, 2.0f);
  expectKnown("a vertex", list.VtxBuffer[3].pos.x, -1.0f);
  expectKnown("its colour", list.VtxBuffer[3].col, 1u);
  expectKnown("a triangle", list.IdxBuffer[2], ImDrawIdx(list.IdxBuffer[2] + 1));
  expectKnown("what is cut off", command.ClipRect.z, command.ClipRect.z + 1);
  expectKnown("how many triangles", command.ElemCount, command.ElemCount + 3);
  expectKnown("where they begin", command.IdxOffset, command.IdxOffset + 3);
  expectKnown("where their vertices begin", command.VtxOffset, command.VtxOffset + 1);
  EXPECT_EQ(digestOf(frame), before);
}

}  // namespace
}  // namespace loomlight
