#include "ui/viewport/view_labels.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/windowless_ui.h"

namespace loomlight {
namespace {

using Rect = WidgetProbe::Rect;

const ImVec2 kMin(268, 36), kMax(756, 568);  // the picture in the smallest window

/// All labels that there can be at once, as small and as large windows have them.
std::vector<Rect> labels(const ViewportModel& model, ImVec2 max) {
  test::WindowlessUi desk(ImVec2(1920, 1080));
  InsetView inset;
  inset.toggle();
  desk.frame(Theme::dark(), [&](Ui& ui) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(1920, 1080));
    ImGui::Begin("viewport", nullptr, ImGuiWindowFlags_NoDecoration);
    viewLabels(ui, model, inset, kMin, max);
    ImGui::End();
  });
  std::vector<Rect> found;
  for (const char* const id : {"view.flat", "view.hint", "view.ways", "view.error"})
    found.push_back(desk.probe().snapshot().widgets.at(id));
  return found;
}

ViewportModel allAtOnce() {
  ViewportModel model;
  model.flat = "Flat \u00b7 4 \u00d7 4 repeats \u00b7 100.0 \u00d7 105.3 mm";
  model.plain = model.denoised = model.proofed = model.warned = true;
  model.error =
      "/home/somebody/with a long name/cloths for the autumn/meshes/a coat.obj:1: expected 3 numbers for a "
      "vertex, got \"0 0 zero\"";
  return model;
}

TEST(ViewLabels, NoneCoversAnotherOrLeavesThePicture) {
  for (const float right : {kMax.x, 1500.0f}) {
    const std::vector<Rect> found = labels(allAtOnce(), ImVec2(right, kMax.y));
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_GE(found[i].x0, kMin.x) << i;
      EXPECT_LE(found[i].x1, right) << i;
      for (size_t k = i + 1; k < found.size(); ++k) {
        const bool apart = found[i].x1 <= found[k].x0 || found[k].x1 <= found[i].x0 || found[i].y1 <= found[k].y0 ||
                           found[k].y1 <= found[i].y0;
        EXPECT_TRUE(apart) << i << " and " << k;
      }
    }
  }
}

TEST(ViewLabels, WhatIsWrongIsBrokenIntoLines) {
  ViewportModel shorter = allAtOnce();
  shorter.error = "no such file";
  const Rect one = labels(shorter, kMax).back(), several = labels(allAtOnce(), kMax).back();
  EXPECT_GT(several.y1 - several.y0, 1.5f * (one.y1 - one.y0));
}

TEST(ViewLabels, StandBesideEachOtherWhereThereIsRoom) {
  const std::vector<Rect> found = labels(allAtOnce(), ImVec2(1800, kMax.y));
  EXPECT_EQ(found[0].y0, found[1].y0);
  EXPECT_EQ(found[0].y0, found[2].y0);
  EXPECT_GT(found[3].y0, found[0].y1);
}

}  // namespace
}  // namespace loomlight
