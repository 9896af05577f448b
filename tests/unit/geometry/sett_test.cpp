#include <gtest/gtest.h>

#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/geometry/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// Of the fibres' length in a cell that are of the yarn's body, where the middle lies across it.
double middleAcross_mm(const CellStrands& cell) {
  double sum = 0, length = 0;
  for (const CellStrands::Strand& strand : cell.strands) {
    if (strand.loose) continue;
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
      const double piece = glm::distance(cell.points[i], cell.points[i + 1]);
      sum += piece * 0.5 * (cell.points[i].x + cell.points[i + 1].x);
      length += piece;
    }
  }
  return sum / length;
}

/// Distances of neighbouring threads, in a few lines across the cloth.
std::vector<double> distances_mm(const ClothGeometry& cloth, System system, int threads, int lines) {
  std::unordered_map<YarnCellKey, double, YarnCellKeyHash> known;
  const auto middleOf = [&](int across, int along) {
    const YarnCellKey key =
        system == System::warp ? cloth.key(system, along, across) : cloth.key(system, across, along);
    const auto [entry, isNew] = known.try_emplace(key);
    if (isNew) entry->second = middleAcross_mm(cloth.strands(key));
    return entry->second;
  };
  const double pitch_mm = cloth.yarn(system, 0).crossPitch_mm;
  std::vector<double> distances;
  for (int line = 0; line < lines; ++line)
    for (int i = 0; i < threads; ++i)
      distances.push_back(pitch_mm + middleOf(i + 1, 997 * line) - middleOf(i, 997 * line));
  return distances;
}

double variation_percent(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / static_cast<double>(values.size());
  return 100 * std::sqrt(squares / static_cast<double>(values.size()) - mean * mean) / mean;
}

// Of n distances a standard deviation is known to within 1 / sqrt(2 n); neighbours share a thread, so half as many
// count. 3000 leave 1.8 %, four of which and a fibre section that is not quite symmetric are within the 10 % that
// fields keep.
TEST(Sett, NeighboursDifferInTheirDistanceAsAsked) {
  for (Fabric fabric : {cloths::plain(), cloths::slubby(), cloths::pliedSatin()})
    for (const double cv_percent : {3.0, 8.0}) {
      SCOPED_TRACE(testing::Message() << fabric.name << ", " << cv_percent << " %");
      fabric.settCv_percent = cv_percent;
      const ClothGeometry cloth(fabric, 4, 4);
      for (const System system : {System::warp, System::weft})
        EXPECT_NEAR(variation_percent(distances_mm(cloth, system, 250, 12)), cv_percent, 0.1 * cv_percent);
    }
}

TEST(Sett, IsEvenWhereItIsAskedToBe) {
  Fabric fabric = cloths::plain();
  fabric.settCv_percent = 0;
  EXPECT_LT(variation_percent(distances_mm(ClothGeometry(fabric, 4, 4), System::warp, 30, 3)), 0.5);
}

TEST(Sett, MassAndThicknessAreThoseOfAnEvenOne) {
  Fabric fabric = cloths::slubby();
  const ClothMeasures uneven = ClothGeometry(fabric, 40, 40).measure();
  fabric.settCv_percent = 0;
  const ClothMeasures even = ClothGeometry(fabric, 40, 40).measure();
  EXPECT_EQ(uneven.arealMass_g_m2, even.arealMass_g_m2);
  EXPECT_EQ(uneven.thickness_mm, even.thickness_mm);
}

}  // namespace
}  // namespace loomlight
