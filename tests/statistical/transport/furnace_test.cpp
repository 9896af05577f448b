#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/choice_names.h"
#include "render/media/close_up_medium.h"
#include "render/media/loomlight_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_medium.h"
#include "tests/support/every_sample.h"
#include "tests/support/mesh_drape.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/white_light.h"

namespace loomlight {
namespace {

using test::MediumKind;

constexpr int kSide = 32;           // pixels of a picture
constexpr double kDistance_mm = 5;  // of the eye from the middle of the cloth

/// Radiance of the paths that meet a fibre.
test::SampledMean radianceOf(const Scene& scene, const Medium& medium, int side, uint32_t samples) {
  test::SampledMean radiance;
  test::forEachSample(scene, medium, side, samples, [&](int, int, const PathSample& sample) {
    if (sample.alpha > 0) radiance.add(sample.direct.g + sample.indirect.g);
  });
  return radiance;
}

struct Case {
  const MediumKind& medium;
  DrapeKind drape = DrapeKind::flat;
  int resolution = 4;
  std::optional<LoomlightMedium::Ingredients> ingredients = std::nullopt;  ///< of kLoomlight
};

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  const Case& c = info.param;
  std::string name = std::string(c.medium.name) + "_" + ChoiceNames<DrapeKind>::names[static_cast<size_t>(c.drape)] +
                     "_" + std::to_string(c.resolution);
  if (c.ingredients) {
    name += "_with";
    if (c.ingredients->finiteRadius) name += "_radius";
    if (c.ingredients->packing) name += "_packing";
    if (c.ingredients->hotSpot) name += "_hotSpot";
  }
  return name;
}

/// Each medium on each drape, and by turns at each resolution: any two of the three come together in a case.
std::vector<Case> cases() {
  constexpr const MediumKind* kMedia[] = {&test::kPlain,          &test::kLoomlight,     &test::kFibres,
                                          &test::kReportsLaw,     &test::kCloseUp,       &test::kLoomlightAtRandom,
                                          &test::kFibresAtRandom, &test::kFibresInBricks};
  constexpr DrapeKind kDrapes[] = {DrapeKind::flat,    DrapeKind::cylinder, DrapeKind::sphere, DrapeKind::folds,
                                   DrapeKind::cushion, DrapeKind::skirt,    DrapeKind::mesh};
  constexpr int kResolutions[] = {4, 1, 2, 8, 16};
  std::vector<Case> all;
  for (size_t m = 0; m < std::size(kMedia); ++m)
    for (size_t d = 0; d < std::size(kDrapes); ++d)
      all.push_back({*kMedia[m], kDrapes[d], kResolutions[(m + d) % std::size(kResolutions)]});
  all.push_back({test::kFibresOfOneRepeat});
  for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder})
    for (int parts = 0; parts < 7; ++parts)  // 7: all of them, as above
      all.push_back({test::kLoomlight, drape, 4,
                     LoomlightMedium::Ingredients{(parts & 1) != 0, (parts & 2) != 0, (parts & 4) != 0}});
  return all;
}

class WhiteFurnace : public testing::TestWithParam<Case> {};

// A white fabric under light of radiance 1 from everywhere has radiance 1 wherever there is a fibre: invariant 7. Light
// is looked for at every event, so this holds only if what stops a look is what stops a flight, at the same places and
// as often; and if paths and looks, weighted against each other by the densities that fibres and lamps tell, share all
// light out between them.
TEST_P(WhiteFurnace, ClothIsInvisible) {
  const Case& c = GetParam();
  const test::WhiteLight white;
  const test::MeshDrape saddle;
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].count_tex = 10;
  fabric.drape.kind = c.drape;
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.drape.radius_mm = 1;
  if (c.drape == DrapeKind::mesh) saddle.giveTo(fabric);
  fabric.camera.distance_mm = kDistance_mm;
  fabric.render.resolution = c.resolution;
  c.medium.askFor(fabric);
  if (c.medium.fromNear) fabric.camera.fov_deg = 6;
  white.shineOn(fabric);
  const auto scene = test::sceneOf(fabric);
  ASSERT_TRUE(scene->lighting->wantsSampling());
  std::unique_ptr<const Medium> medium = c.medium.make(*scene);
  if (c.ingredients) medium = std::make_unique<const LoomlightMedium>(scene->cloth, *c.ingredients);
  if (c.medium.fromNear) {
    const RayCone pixel = CameraRays(fabric.camera, kSide, kSide).ray(0.5f * kSide, 0.5f * kSide).cone;
    const float chance = closeUpChance(*scene->cloth, pixel.widthAt(kDistance_mm));
    ASSERT_GT(chance, 0) << "no path goes among fibres";
    ASSERT_LT(chance, 1) << "no path begins in the volume";
  }
  // What all media share, weights and densities, is looked at closely where that costs least.
  const bool isFirst = &c.medium == &test::kPlain && c.drape == DrapeKind::flat && c.resolution == 4;
  const test::SampledMean radiance = radianceOf(*scene, *medium, kSide, isFirst ? 160 : 16);
  EXPECT_LT(radiance.standardError(), isFirst ? 0.001 : 0.005);
  EXPECT_TRUE(test::isWithinNoise(radiance.mean(), 1, radiance.standardError(), static_cast<int>(cases().size())));
}

INSTANTIATE_TEST_SUITE_P(Every, WhiteFurnace, testing::ValuesIn(cases()), nameOf);

// A dyed cloth in the furnace is darker than white, and brighter than its surface reflection alone.
TEST(WhiteFurnaceOfDyedCloth, KeepsBetweenReflectionAndWhite) {
  Fabric fabric = test::whiteCotton();
  fabric.fibres[0].absorption_per_mm = Rgb(5.0f, 20.0f, 200.0f);
  fabric.light.kind = LightKind::furnace;
  const auto scene = test::sceneOf(fabric);
  const auto medium = test::kPlain.make(*scene);
  Rgb sum(0.0f);
  float alpha = 0;
  test::forEachSample(*scene, *medium, 16, 16, [&](int, int, const PathSample& sample) {
    sum += sample.direct + sample.indirect;
    alpha += sample.alpha;
  });
  const Rgb mean = sum / alpha;
  EXPECT_LT(mean.r, 1.0f);
  EXPECT_LT(mean.g, mean.r);
  EXPECT_LT(mean.b, mean.g);
  EXPECT_GT(mean.b, 0.005f);  // what the surfaces mirror, however dark the inside
}

}  // namespace
}  // namespace loomlight
