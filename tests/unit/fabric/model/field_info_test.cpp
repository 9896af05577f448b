#include "core/fabric/model/field_info.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/wif_origin.h"

namespace loomlight {
namespace {

static_assert(fieldInfo(&Yarn::plies).max == 8);
static_assert(fieldInfo(&Fabric::ends_per_cm).min == 0.2);

template <class T>
class FieldTableOf : public testing::Test {};
using Tables = testing::Types<Dyestuff, Fibre, Yarn, Drape, Light, Camera, RenderSettings, Draft, Colourway, MillData,
                              WifYarn, WifOrigin, Fabric>;
TYPED_TEST_SUITE(FieldTableOf, Tables);

TYPED_TEST(FieldTableOf, KeysAreUniqueAndEveryEntryIsExplained) {
  std::set<std::string> keys;
  forEachField<TypeParam>([&](const auto& field) {
    EXPECT_TRUE(keys.insert(field.info.key).second) << field.info.key;
    EXPECT_NE(std::string(field.info.label), "") << field.info.key;
    EXPECT_NE(std::string(field.info.help), "") << field.info.key;
    EXPECT_EQ(std::string(field.info.key).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string::npos);
  });
}

TYPED_TEST(FieldTableOf, LogarithmicRangesStartAboveZeroOrAreSaidTo) {
  forEachField<TypeParam>([&](const auto& field) {
    const std::string key = field.info.key;
    const bool zeroAllowed = key == "absorption_per_mm" || key == "intensity";
    if (field.info.logarithmic) {
      EXPECT_TRUE(zeroAllowed || field.info.min > 0) << key;
    }
  });
}

TEST(FieldInfo, IsFoundByItsMember) {
  EXPECT_STREQ(fieldInfo(&Yarn::plyTwist_per_m).key, "ply_twist_per_m");
  EXPECT_STREQ(fieldInfo(&Yarn::yarnTwist_per_m).key, "yarn_twist_per_m");
  EXPECT_STREQ(fieldInfo(&Fabric::warpSequence).key, "") << "lists are no plain fields";
}

/// A member that is missing in its table would be neither saved nor compared: every plain member has to be seen.
TEST(FieldTables, CoverEveryMember) {
  const auto count = []<class T>(const T&) {
    int n = 0;
    forEachField<T>([&](const auto&) { ++n; });
    return n;
  };
  // Structured bindings fail to compile when a member is added, and then this test and the table are to be looked at.
  [[maybe_unused]] const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, fu] = Fibre{};
  EXPECT_EQ(count(Fibre{}), 9);
  [[maybe_unused]] const auto& [s1, s2, s3] = Dyestuff{};
  EXPECT_EQ(count(Dyestuff{}), 3);
  [[maybe_unused]] const auto& [y1, y2, y3, y4, y5, y6, y7, y8, y9, y10, y11, y12, y13, y14, y15, y16, y17, y18, y19,
                                y20, y21, y22, y23, y24, y25, y26, y27, yu] = Yarn{};
  EXPECT_EQ(count(Yarn{}), 27);
  [[maybe_unused]] const auto& [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, mu] = MillData{};
  EXPECT_EQ(count(MillData{}), 9) << "the denting is a list, and no plain field";
  [[maybe_unused]] const auto& [d1, d2, d3, d4, d5, d6, d7, du] = Drape{};
  EXPECT_EQ(count(Drape{}), 7);
  [[maybe_unused]] const auto& [l1, l2, l3, l4, l5, l6, l7, l8, l9, lu] = Light{};
  EXPECT_EQ(count(Light{}), 9);
  [[maybe_unused]] const auto& [c1, c2, c3, c4, c5, cu] = Camera{};
  EXPECT_EQ(count(Camera{}), 5);
  [[maybe_unused]] const auto& [r1, r2, r3, r4, r5, r6, r7, r8, r9, r10, ru] = RenderSettings{};
  EXPECT_EQ(count(RenderSettings{}), 10);
  [[maybe_unused]] const auto& [g1, g2, g3, g4, g5, g6, g7, gu] = Draft{};
  EXPECT_EQ(count(Draft{}), 3) << "threading, tie-up, treadling and liftplan are lists";
  [[maybe_unused]] const auto& [k1, k2, ku] = Colourway{};
  EXPECT_EQ(count(Colourway{}), 1) << "its colours are a list";
  [[maybe_unused]] const auto& [w1, w2, wu] = WifYarn{};
  EXPECT_EQ(count(WifYarn{}), 2);
  [[maybe_unused]] const auto& [o1, o2, o3, o4, o5, o6, o7, o8, o9, o10, o11, o12, o13, ou] = WifOrigin{};
  EXPECT_EQ(count(WifOrigin{}), 7) << "diameters, spacings and yarns are lists, and the rest lines";
  [[maybe_unused]] const auto& [a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19,
                                a20, a21, a22, a23, a24, a25, a26, a27, au] = Fabric{};
  EXPECT_EQ(count(Fabric{}), 12)
      << "weave, draft, sequences, spacings, kinds and what is beside the cloth are no plain fields";
}

TEST(FieldTables, ComparisonIgnoresUnknownKeysOnly) {
  Yarn a, b;
  EXPECT_EQ(a, b);
  b.migration = 0.25;
  EXPECT_NE(a, b);
}

TEST(ChoiceNames, ThereAndBack) {
  EXPECT_STREQ(choiceName(LightKind::environment), "environment");
  EXPECT_EQ(choiceFromName<LightKind>("headlight"), LightKind::headlight);
  EXPECT_EQ(choiceFromName<DrapeKind>("tube"), std::nullopt);
  EXPECT_EQ(choiceList<FibreLayout>(), "\"random\" or \"packed\"");
  EXPECT_EQ(ChoiceNames<LightKind>::names.size(), static_cast<size_t>(LightKind::environment) + 1);
  EXPECT_EQ(ChoiceNames<FibreSection>::names.size(), static_cast<size_t>(FibreSection::polygon) + 1);
  EXPECT_EQ(ChoiceNames<DrapeKind>::names.size(), static_cast<size_t>(DrapeKind::mesh) + 1);
}

}  // namespace
}  // namespace loomlight
