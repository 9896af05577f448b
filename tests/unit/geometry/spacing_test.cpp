#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/weave/turned_over.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// Open cloth of a fine filament, whose threads have room to lie unevenly.
Fabric open(const std::vector<double>& warpSpacing, const std::vector<double>& weftSpacing) {
  Fabric f = cloths::plain();
  f.yarns[0].count_tex = 4;
  f.yarns[0].plyTwist_per_m = 0;
  f.warpSpacing = warpSpacing;
  f.weftSpacing = weftSpacing;
  return f;
}

/// The place of a thread along x (ends) or y (picks) in the middle of a cell, mm: the mean of its fibres there.
double place_mm(const ClothGeometry& cloth, System system, int across, int along) {
  const bool warp = system == System::warp;
  const CellStrands cell = cloth.strands(cloth.key(system, warp ? along : across, warp ? across : along));
  double sum = 0;
  for (const glm::vec3& point : cell.points) sum += point.x;
  const double mean = sum / static_cast<double>(cell.points.size());
  return (across + 0.5) * (warp ? cloth.warpPitch_mm() : cloth.weftPitch_mm()) + (warp ? mean : -mean);
}

/// Where along itself a yarn is highest in a cell, mm from that cell's corner.
double crown_mm(const ClothGeometry& cloth, System system, int across, int along) {
  const bool warp = system == System::warp;
  const YarnCellKey key = cloth.key(system, warp ? along : across, warp ? across : along);
  const CellStrands cell = cloth.strands(key);
  const float side = key.here.height_mm > 0 ? 1.0f : -1.0f;
  // Its top is flat for want of points: the middle of what lies within a hair of the highest.
  float highest = -1e9f;
  for (const glm::vec3& point : cell.points) highest = std::max(highest, side * point.z);
  double sum = 0, count = 0;
  for (const glm::vec3& point : cell.points)
    if (side * point.z > highest - 0.002f) {
      sum += point.y;
      ++count;
    }
  return (along + 0.5) * (warp ? cloth.weftPitch_mm() : cloth.warpPitch_mm()) + sum / count;
}

TEST(ThreadSpacing, IsThePlaceOfEachThreadBesideAnEvenSett) {
  EXPECT_TRUE(displacements({}).empty());
  EXPECT_TRUE(displacements({2, 2, 2}).empty()) << "even";
  // Places 0, 1 of a repeat of 3, whose even places are 0, 1.5.
  ASSERT_EQ(displacements({1, 2}).size(), 2u);
  EXPECT_NEAR(displacements({1, 2})[0], 1.0 / 6, 1e-12);
  EXPECT_NEAR(displacements({1, 2})[1], -1.0 / 6, 1e-12);
  const std::vector<double> spacing{1, 1, 3, 2}, displaced = displacements(spacing);
  const double pitch = 7.0 / 4;
  for (size_t i = 0; i < 4; ++i) {
    const double next = i == 3 ? displaced[0] + 4 : displaced[i + 1] + static_cast<double>(i) + 1;
    EXPECT_NEAR((next - displaced[i] - static_cast<double>(i)) * pitch, spacing[i], 1e-12) << i;
  }
  const auto [least, most] = std::minmax_element(displaced.begin(), displaced.end());
  EXPECT_NEAR(*least, -*most, 1e-12);
}

TEST(ThreadSpacing, IsReadAsItIsWritten) {
  EXPECT_EQ(spacingFromText(" 1 2.5  1 "), (std::vector<double>{1, 2.5, 1}));
  EXPECT_EQ(spacingText({1, 2.5, 1}), "1 2.5 1");
  EXPECT_EQ(spacingFromText(""), std::vector<double>());
  EXPECT_EQ(spacingFromText("   "), std::vector<double>());
  for (const char* wrong : {"1 two", "1,2", "0.05 1", "11", "-1", "nan", "1 inf", "1..2", "1e", "0x1"})
    EXPECT_FALSE(spacingFromText(wrong)) << wrong;
  std::string many;
  for (int i = 0; i < kMostSpacing; ++i) many += " 1";
  EXPECT_TRUE(spacingFromText(many));
  EXPECT_FALSE(spacingFromText(many + " 1"));
}

TEST(Spacing, ThreadsLieAsFarApartAsAsked) {
  const ClothGeometry cloth(open({1, 2}, {1, 1, 2}), 12, 12);
  for (const System system : {System::warp, System::weft}) {
    ASSERT_EQ(cloth.yarns().threads(system).share, 1);
    const std::vector<double> spacing =
        system == System::warp ? std::vector<double>{1, 2} : std::vector<double>{1, 1, 2};
    double sum = 0;
    for (const double distance : spacing) sum += distance;
    const double unit_mm = (system == System::warp ? cloth.warpPitch_mm() : cloth.weftPitch_mm()) *
                           static_cast<double>(spacing.size()) / sum;
    for (int thread = 0; thread < 6; ++thread) {
      const double apart = place_mm(cloth, system, thread + 1, 3) - place_mm(cloth, system, thread, 3);
      EXPECT_NEAR(apart, unit_mm * spacing[static_cast<size_t>(thread) % spacing.size()], 0.01 * unit_mm) << thread;
    }
  }
}

// A yarn is uppermost where the thread lies that it crosses, not in the middle of the cell.
TEST(Spacing, YarnsBendOverThreadsWhereTheyLie) {
  const ClothGeometry cloth(open({1, 2}, {1, 1, 2}), 12, 12);
  for (const System system : {System::warp, System::weft}) {
    const System other = system == System::warp ? System::weft : System::warp;
    const double pitch = system == System::warp ? cloth.weftPitch_mm() : cloth.warpPitch_mm();
    for (int along = 0; along < 6; ++along)
      EXPECT_NEAR(crown_mm(cloth, system, 2, along), place_mm(cloth, other, along, 2), 0.03 * pitch) << along;
  }
}

TEST(Spacing, YarnsThatHaveNoRoomLieAsCloseAsTheyCan) {
  Fabric dense = open({1, 3}, {});
  dense.yarns[0].count_tex = 40;
  const ClothGeometry cloth(dense, 8, 8);
  const ThreadKinds& ends = cloth.yarns().threads(System::warp);
  EXPECT_GT(ends.share, 0);
  EXPECT_LT(ends.share, 1);
  const double closest_mm = cloth.warpPitch_mm() - 2 * ends.farthest_mm();
  const double width_mm = 2 * cloth.yarn(System::warp, 0).halfWidth_mm();
  EXPECT_NEAR(closest_mm, 0.9 * width_mm, 1e-6) << "their sections touch, pressed in by a tenth";
  EXPECT_EQ(cloth.yarns().threads(System::weft).share, 1) << "nothing is asked of picks";

  Fabric jammed = dense;  // of wires that nothing presses, thicker than their pitch
  jammed.yarns[0].fibresPerPly = 1;
  jammed.fibres[0].radius_um = 200;
  jammed.ends_per_cm = 30;
  const ClothGeometry tight(jammed, 8, 8);
  EXPECT_EQ(tight.yarns().threads(System::warp).share, 0);
  EXPECT_EQ(tight.yarns().threads(System::warp).farthest_mm(), 0);
  EXPECT_EQ(tight.repeatEnds(), 2) << "as if nothing had been asked";
}

// The threads of a piece that is turned over lie where they lay: only seen from the other side.
TEST(Spacing, TurnedOverItIsTheSameCloth) {
  const Fabric face = open({1, 1.5, 2, 1}, {1, 2});
  const ClothGeometry cloth(face, 8, 8), back(turnedOver(face), 8, 8);
  const auto placesOf = [](const ClothGeometry& of, bool mirrored) {
    std::vector<double> places;
    for (int end = 0; end < 4; ++end) places.push_back(place_mm(of, System::warp, mirrored ? 3 - end : end, 0));
    for (double& place : places) place = mirrored ? 4 * of.warpPitch_mm() - place : place;
    return places;
  };
  const std::vector<double> there = placesOf(cloth, false), here = placesOf(back, true);
  for (size_t end = 1; end < 4; ++end) EXPECT_NEAR(there[end] - there[0], here[end] - here[0], 0.002) << end;
}

// What no thread of a system has asks for no room in it, and what repeats within itself is as good as its part.
TEST(Spacing, DependsOnTheYarnsThatAreWoven) {
  const Fabric fabric = open({1, 2}, {});
  Fabric other = fabric;
  other.warpSpacing = {1, 2, 1, 2};
  other.yarns.push_back(other.yarns[0]);
  other.yarns.back().count_tex = 500;
  const ClothGeometry cloth(fabric, 8, 8), same(other, 8, 8);
  EXPECT_EQ(same.yarns().threads(System::warp).sequence, cloth.yarns().threads(System::warp).sequence);
  EXPECT_EQ(same.yarns().threads(System::warp).share, cloth.yarns().threads(System::warp).share);
  EXPECT_EQ(same.yarns().threads(System::warp).farthest_mm(), cloth.yarns().threads(System::warp).farthest_mm());
}

// As many cells as the spacing has threads are alike at most; and a cloth that is even has no more codes than before.
TEST(Spacing, TheRepeatIsThatOfWeaveAndSpacing) {
  const ClothGeometry cloth(open({1, 2, 1}, {1, 1, 1, 2}), 24, 24);
  EXPECT_EQ(cloth.repeatEnds(), 6);
  EXPECT_EQ(cloth.repeatPicks(), 4);
  const ClothGeometry even(open({2, 2, 2}, {1}), 24, 24);
  EXPECT_EQ(even.repeatEnds(), 2);
}

// Yarns weigh what their axes are long: cells share out the axis between them, wherever the crossings lie in them.
TEST(Spacing, CellsShareOutTheirYarnsAxis) {
  const ClothGeometry cloth(cloths::spaced(), 40, 40);
  for (const System system : {System::warp, System::weft}) {
    const bool warp = system == System::warp;
    const int around = warp ? cloth.repeatPicks() : cloth.repeatEnds();
    double cells_mm = 0, axis_mm = 0, spans_mm = 0, pitch_mm = 0;
    for (int along = 0; along < around; ++along) {
      const YarnCellKey key = warp ? cloth.key(system, along, 0) : cloth.key(system, 0, along);
      pitch_mm = cloth.yarn(system, key.yarn).pitch_mm;
      const double span_mm = spanBetween_mm(key.here, key.next, pitch_mm);
      cells_mm += cloth.yarns().axisLength_mm(key);
      axis_mm += Transition(key.here, key.next, span_mm).length_mm();
      spans_mm += span_mm;
    }
    EXPECT_NEAR(spans_mm, around * pitch_mm, 1e-5);
    EXPECT_GT(axis_mm, spans_mm);
    EXPECT_NEAR(cells_mm, axis_mm, 1e-5);
  }
}

}  // namespace
}  // namespace loomlight
