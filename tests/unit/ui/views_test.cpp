#include <gtest/gtest.h>

#include <cmath>

#include "ui/dock_layout.h"
#include "ui/viewport/camera_moves.h"
#include "ui/widgets/crossing_index.h"

namespace loomlight {
namespace {

constexpr double kRadian = kPi / 180;

/// Where a point of the scene is in the picture, pixels from its centre, right and down: the pinhole of Camera.
glm::dvec2 project(const Camera& camera, const glm::dvec3& point, int height) {
  const double a = camera.azimuth_deg * kRadian, e = camera.elevation_deg * kRadian;
  const glm::dvec3 away(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  const glm::dvec3 right(-std::sin(a), std::cos(a), 0), up = glm::cross(away, right);
  const glm::dvec3 d = point - (camera.target_mm + camera.distance_mm * away);
  const double scale = 0.5 * height / std::tan(0.5 * camera.fov_deg * kRadian) / -glm::dot(d, away);
  return {scale * glm::dot(d, right), -scale * glm::dot(d, up)};
}

Camera someCamera() {
  Camera camera;
  camera.target_mm = {1, -2, 0.5};
  camera.azimuth_deg = -60;
  camera.elevation_deg = 40;
  return camera;
}

/// A point of the plane through the target, facing the camera, that is seen at (x, y).
glm::dvec3 pointAt(const Camera& camera, double x, double y, int height) {
  return panned(camera, -x, -y, height).target_mm;
}

TEST(CameraMoves, WhatIsUnderThePointerStaysThereWhileZooming) {
  const Camera camera = someCamera();
  const glm::dvec3 point = pointAt(camera, 120, -75, 600);
  const glm::dvec2 before = project(camera, point, 600);
  EXPECT_NEAR(before.x, 120, 1e-6);
  EXPECT_NEAR(before.y, -75, 1e-6);
  for (double clicks : {-3.0, 1.0, 5.0}) {
    const glm::dvec2 after = project(zoomed(camera, clicks, 120, -75, 600), point, 600);
    EXPECT_NEAR(after.x, 120, 1e-6) << clicks;
    EXPECT_NEAR(after.y, -75, 1e-6) << clicks;
  }
}

TEST(CameraMoves, PanningDragsThePointAlong) {
  const Camera camera = someCamera();
  const glm::dvec2 after = project(panned(camera, 33, 44, 600), camera.target_mm, 600);
  EXPECT_NEAR(after.x, 33, 1e-6);
  EXPECT_NEAR(after.y, 44, 1e-6);
}

TEST(CameraMoves, OrbitTurnsTheNearSideWithTheMouse) {
  Camera camera;  // stands at -y, looks towards +y
  const Camera moved = orbited(camera, 30, 0);
  const glm::dvec3 nearSide(0, -5, 0);
  EXPECT_GT(project(moved, nearSide, 600).x, project(camera, nearSide, 600).x);
  EXPECT_DOUBLE_EQ(moved.distance_mm, camera.distance_mm);
  EXPECT_LE(orbited(camera, 0, 1e6).elevation_deg, 90);
  EXPECT_GE(orbited(camera, 0, -1e6).elevation_deg, -90);
  EXPECT_LE(std::abs(orbited(camera, 1e6, 0).azimuth_deg), 360);
}

TEST(CameraMoves, FitShowsEveryCornerOfTheCloth) {
  Drape drape;
  drape.width_mm = 37;
  drape.height_mm = 11;
  const int height = 500;
  for (double aspect : {0.5, 1.0, 2.0}) {
    const Camera camera = fitted(someCamera(), drape, aspect, {});
    for (double x : {-18.5, 18.5})
      for (double y : {-5.5, 5.5}) {
        const glm::dvec2 p = project(camera, {x, y, 0}, height);
        EXPECT_LE(std::abs(p.x), 0.5 * aspect * height);
        EXPECT_LE(std::abs(p.y), 0.5 * height);
      }
  }
}

TEST(CameraMoves, AViewpointTurnsAboutWhatIsLookedAt) {
  const glm::dvec3 target = someCamera().target_mm;
  for (const Viewpoint viewpoint : {Viewpoint::above, Viewpoint::aslant, Viewpoint::grazing}) {
    const Camera camera = turnedTo(someCamera(), viewpoint);
    EXPECT_NEAR(glm::length(project(camera, target, 600)), 0, 1e-9);
    const glm::dvec2 nextEnd = project(camera, target + glm::dvec3(0.1, 0, 0), 600);
    const glm::dvec2 nextPick = project(camera, target + glm::dvec3(0, 0.1, 0), 600);
    EXPECT_GT(nextEnd.x, 0);
    EXPECT_NEAR(nextEnd.y, 0, 1e-9);
    EXPECT_NEAR(nextPick.x, 0, 1e-9);
    EXPECT_LT(nextPick.y, 0) << "the next pick is further up";
  }
}

TEST(CrossingIndex, WrapsIntoTheRepeatFromBothSides) {
  const Weave weave = Weave().resized(5, 3);
  EXPECT_EQ(inRepeat({-1, -1}, weave), (CrossingIndex{2, 4}));
  EXPECT_EQ(inRepeat({7, 12}, weave), (CrossingIndex{1, 2}));
}

TEST(Desk, TheClothKeepsHalfOfTheWindow) {
  DockLayout layout;
  layout.draftWidth = layout.inspectorWidth = 5000;
  for (const ImVec2 screen : {ImVec2(1280, 720), ImVec2(1440, 900), ImVec2(2560, 1440)})
    for (float scale : {1.0f, screen.x / 1280}) {
      const DockAreas areas = dockAreas(layout, screen, 31 * scale, scale);
      EXPECT_GE(areas.viewport.size.x, 0.5f * screen.x - 1);
      EXPECT_NEAR(areas.inspector.min.x + areas.inspector.size.x, screen.x, 1);
      EXPECT_NEAR(areas.status.min.y + areas.status.size.y, screen.y, 1);
    }
}

TEST(Desk, PanelsThatNobodyDraggedGrowWithTheScreen) {
  float last = 0;
  for (const float width : {1280.0f, 1600.0f, 1920.0f}) {
    const DockAreas areas = dockAreas(DockLayout{}, ImVec2(width, 900), 31, 1);
    EXPECT_GT(areas.draft.size.x, last);
    last = areas.draft.size.x;
  }
  DockLayout dragged;
  dragged.draftWidth = 300;
  EXPECT_EQ(dockAreas(dragged, ImVec2(1920, 1080), 31, 1).draft.size.x, 300);
}

}  // namespace
}  // namespace loomlight
