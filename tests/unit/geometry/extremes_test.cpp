#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight {
namespace {

/// A number between the ends of its valid range: often one of them, else anything between, evenly by its logarithm.
class Pick {
 public:
  explicit Pick(uint64_t seed) : random_(seed) {}
  double number(double low, double high) {
    switch (random_.below(4)) {
      case 0:
        return low;
      case 1:
        return high;
      default: {
        const double base = std::max(low, 1e-3 * high);
        return std::clamp(base * std::pow(high / base, random_.uniformDouble()), low, high);
      }
    }
  }
  int whole(int low, int high) { return static_cast<int>(std::lround(number(low, high))); }
  bool toss() { return random_.below(2) != 0; }

 private:
  Random random_;
};

Fabric anyValidFabric(uint64_t seed) {
  Pick pick(seed);
  Fabric f;
  f.fibres[0].radius_um = pick.number(1, 200);
  f.fibres[0].density_g_cm3 = pick.number(0.2, 20);
  f.ends_per_cm = pick.number(0.2, 500);
  f.picks_per_cm = pick.number(0.2, 500);
  f.yarns.clear();
  for (int i = 0; i < 2; ++i) {
    Yarn y;
    y.count_tex = pick.number(0.5, 5000);
    if (pick.toss()) y.fibresPerPly = pick.whole(1, 2000);
    y.plies = pick.whole(1, 8);
    if (pick.toss()) y.cords = pick.whole(1, 6);
    // A cable of 96 000 fibres is valid too, but nobody's cloth, and takes minutes.
    const int singles = y.plies * y.cords, most = 4000 / singles;
    if (y.fibresPerPly) y.fibresPerPly = std::min(*y.fibresPerPly, most);
    y.cableTwist_per_m = pick.number(0, 5000);
    if (pick.toss()) y.cableTwistDirection = TwistDirection::s;
    y.plyTwist_per_m = pick.number(0, 5000);
    y.yarnTwist_per_m = pick.number(0, 5000);
    if (pick.toss()) y.plyTwistDirection = TwistDirection::s;
    if (pick.toss()) y.yarnTwistDirection = TwistDirection::z;
    y.packing = pick.number(0.05, 0.85);
    y.flattening = pick.number(1, 4);
    if (pick.toss()) y.hairiness_per_mm = pick.number(0, 50);
    y.hairLength_mm = pick.number(0.05, 3);
    if (pick.toss()) y.migration = pick.number(0, 1);
    if (pick.toss()) y.layout = FibreLayout::random;
    f.yarns.push_back(y);
  }
  f.warpSequence = {0, 1};
  f.weftSequence = {1};
  f.weave = Weave({{1, 0, 0, 0, 0, 0}, {0, 1, 1, 1, 0, 1}});
  return f;
}

void expectSound(const ClothGeometry& cloth, const YarnCellKey& key) {
  const YarnGeometry& yarn = cloth.yarn(key.system, key.yarn);
  const CellStrands cell = cloth.strands(key);
  ASSERT_FALSE(cell.strands.empty());
  ASSERT_LT(cell.points.size(), 4u * kMaxPointsPerCell);
  ASSERT_GT(cell.fibreRadius_mm, 0);
  const double halfPitch = 0.5f * static_cast<float>(yarn.pitch_mm);
  double outside = 0;
  for (const glm::vec3& p : cell.points) {
    // NaN fails every comparison.
    if (!(std::abs(p.x) <= 1.5 * yarn.crossPitch_mm && std::abs(p.y) <= halfPitch &&
          std::abs(p.z) <= cloth.halfThickness_mm()))
      ++outside;
  }
  ASSERT_EQ(outside, 0);
  // Every fibre of the body comes in at one end of the cell and leaves at the other.
  size_t fibres = 0;
  for (const CellStrands::Strand& strand : cell.strands) fibres += !strand.loose;
  ASSERT_GE(fibres, static_cast<size_t>(yarn.singles() * yarn.fibresPerPly));
}

/// Some of all; in parts, since each takes seconds.
class AnyValidFabricOf : public testing::TestWithParam<uint64_t> {};

TEST_P(AnyValidFabricOf, HasSoundGeometry) {
  constexpr uint64_t kSeeds = 6;
  for (uint64_t seed = kSeeds * GetParam(); seed < kSeeds * (GetParam() + 1); ++seed) {
    SCOPED_TRACE(seed);
    Fabric fabric = anyValidFabric(seed);
    Pick pick(~seed);
    for (Yarn& y : fabric.yarns) {
      if (pick.toss()) y.evennessCv_percent = pick.number(0, 40);
      if (pick.toss()) y.slubs_per_m = pick.number(0, 50);
      y.slubLength_mm = pick.number(5, 500);
      y.slubRatio = pick.number(1.1, 4);
    }
    if (pick.toss()) fabric.settCv_percent = pick.number(0, 20);
    if (pick.toss()) fabric.crowding = pick.number(0, 3);
    if (pick.toss()) fabric.warpSpacing = {pick.number(0.1, 10), pick.number(0.1, 10), 1};
    if (pick.toss()) fabric.weftSpacing = {pick.number(0.1, 10), 1};
    const ClothGeometry cloth(fabric, 6, 6);
    ASSERT_TRUE(std::isfinite(cloth.halfThickness_mm()));
    for (const System system : {System::warp, System::weft}) {
      expectSound(cloth, cloth.key(system, 0, 0));
      expectSound(cloth, cloth.key(system, 1, 3));
      if (HasFatalFailure()) return;
    }
    const ClothMeasures measures = cloth.measure();
    ASSERT_GE(measures.crimpWarp, -1e-9);
    ASSERT_GE(measures.crimpWeft, -1e-9);
    ASSERT_LT(measures.crimpWarp, 2);
    ASSERT_GT(measures.arealMass_g_m2, 0);
    ASSERT_TRUE(std::isfinite(measures.arealMass_g_m2 + measures.thickness_mm + measures.segmentsPerRepeat));
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, AnyValidFabricOf, testing::Range<uint64_t>(0, 4));

TEST(AnyValidFabric, WeighsItsCount) {
  for (uint64_t seed = 200; seed < 210; ++seed) {
    SCOPED_TRACE(seed);
    const ClothGeometry cloth(anyValidFabric(seed), 6, 6);
    const YarnCellKey first = cloth.key(System::weft, 0, 0);
    const YarnGeometry& yarn = cloth.yarn(System::weft, first.yarn);
    double mass_g = 0, axis_mm = 0;
    for (int phase = 0; phase < yarn.period; ++phase) {
      YarnCellKey key = first;
      key.phase = phase;
      const CellStrands cell = cloth.strands(key);
      mass_g += cell.length_mm() * kPi * cell.fibreRadius_mm * cell.fibreRadius_mm * yarn.fibreDensity_g_cm3 * 1e-3;
      axis_mm += cloth.yarns().axisLength_mm(key);
    }
    EXPECT_NEAR(mass_g / axis_mm * 1e6 / yarn.count_tex, 1, 1e-3);
  }
}

}  // namespace
}  // namespace loomlight
