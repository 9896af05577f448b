#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "core/fabric/model/choice_names.h"
#include "render/media/close_up_medium.h"
#include "render/media/fibre_exit.h"
#include "render/optics/fibre_frame.h"
#include "render/scene/fibre_bricks.h"
#include "tests/support/any_direction.h"
#include "tests/support/every_medium.h"
#include "tests/support/mesh_drape.h"
#include "tests/support/sampled_mean.h"

namespace loomlight {
namespace {

using test::MediumKind;

struct Case {
  const MediumKind& medium;
  DrapeKind drape;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const MediumKind* medium : {&test::kPlain, &test::kLoomlight, &test::kFibres})
    for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder, DrapeKind::sphere, DrapeKind::folds,
                                  DrapeKind::cushion, DrapeKind::skirt, DrapeKind::mesh})
      all.push_back({*medium, drape});
  for (const MediumKind* medium : {&test::kReport, &test::kReportsLaw, &test::kCloseUp, &test::kLoomlightAtRandom,
                                   &test::kFibresAtRandom, &test::kFibresInBricks})
    for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder, DrapeKind::mesh})
      all.push_back({*medium, drape});
  all.push_back({test::kFibresOfOneRepeat, DrapeKind::flat});
  return all;
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.medium.name) + "_" +
         ChoiceNames<DrapeKind>::names[static_cast<size_t>(info.param.drape)];
}

/// Dense packed yarns, close together.
Fabric packedCloth(DrapeKind drape) {
  Fabric fabric = test::whiteCotton();
  Yarn& yarn = fabric.yarns[0];
  yarn.fibresPerPly = 40;
  yarn.packing = 0.7;
  yarn.flattening = 1.5;
  fabric.ends_per_cm = fabric.picks_per_cm = 40;
  fabric.drape.kind = drape;
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.drape.radius_mm = 1;
  fabric.camera.distance_mm = 8;
  fabric.render.resolution = 4;
  return fabric;
}

/// The transmittance that shadow rays give at the end of flights, which by one law is uniform: any flight is as likely
/// to end in the first half of the light's loss as in the second. So its mean is a half, and half of what is left when
/// nothing was met stands for flights that leave. Kept of all departures, and apart for those that know so many fibres
/// (none, one, two, more) and for ways back along the last flight, which the memory of it clears.
class LawComparison {
 public:
  static constexpr int kEvents = 4, kStrata = 2 * kEvents;

  LawComparison(const Medium& medium, uint64_t seed) : medium_(medium), random_(seed) {}

  /// Path 0 has met so many fibres; path 1 is there to fly on from there.
  void add(MediumBatch& paths, int events, glm::vec3 direction, bool back) {
    if (medium_.seesDirectLightApart() && events == 1) return;  // two laws, as the report has it
    const auto seen = [&](float distance) {
      ShadowRay ray{0, direction, distance, &random_};
      paths.transmit({&ray, 1}, counts_);
      return 0.5f * ray.visible;
    };
    paths.copy(0, 1);
    const PathRay on{1, direction, &random_};
    std::optional<Collision> flight;
    paths.collide({&on, 1}, {&flight, 1}, counts_);
    // Just before and just behind the end: explicit fibres block all at once.
    const float value = flight ? seen(flight->distance_mm * (1 - kAside)) + seen(flight->distance_mm * (1 + kAside))
                               : seen(std::numeric_limits<float>::infinity());
    strata_[2 * static_cast<size_t>(std::min(events, kEvents - 1)) + static_cast<size_t>(back)].add(value);
    all_.add(value);
    ended_ += static_cast<int>(flight.has_value());
  }
  const test::SampledMean& all() const { return all_; }
  /// How many flights met a fibre; those that meet none of an empty way say one half whatever the law is.
  int ended() const { return ended_; }
  const std::array<test::SampledMean, kStrata>& strata() const { return strata_; }

 private:
  static constexpr float kAside = 1e-5f;  // more than rounding, and far less than a fibre
  const Medium& medium_;
  Random random_;
  TraceCounts counts_;
  std::array<test::SampledMean, kStrata> strata_;
  test::SampledMean all_;
  int ended_ = 0;
};

class OneLaw : public testing::TestWithParam<Case> {};

// A shadow ray says with which chance a flight gets as far, whatever is remembered of the way before: only then does a
// path that looks for light find as much as one that flies to it.
TEST_P(OneLaw, FlightsGetAsFarAsShadowRaysSee) {
  Fabric fabric = packedCloth(GetParam().drape);
  const test::MeshDrape saddle;
  if (GetParam().drape == DrapeKind::mesh) saddle.giveTo(fabric);
  GetParam().medium.askFor(fabric);
  const auto scene = test::sceneOf(fabric);
  const auto medium = GetParam().medium.make(*scene);
  const FibreBcsdf& bcsdf = *scene->cloth->materials[0].bcsdf;
  const CameraRays camera(fabric.camera, 1, 1);
  LawComparison comparison(*medium, 5);
  Random random(6);
  TraceCounts counts;
  const auto way = medium->batch(2);
  // Half of the paths of an eye that is near begin among fibres, and end in the volume. Their first flight chooses, so
  // that no shadow ray comes before it.
  const bool isNear = GetParam().medium.fromNear;
  const RayCone cone{isNear ? scene->cloth->fibres->thinnest_mm() / 0.625f : 0};
  const int events = isNear ? CloseUpMedium::kMeetings + 2 : LawComparison::kEvents;
  const int paths = GetParam().drape == DrapeKind::flat ? 40000 : 8000;  // a drape takes longer
  for (int path = 0; path < paths; ++path) {
    const float x = random.uniform(), y = random.uniform();
    const Ray ray = camera.ray(x, y);
    way->begin(0, {ray.origin, -1}, cone);
    glm::vec3 direction = ray.direction;
    if (!isNear) comparison.add(*way, 0, direction, false);
    for (int event = 1; event <= events; ++event) {
      const PathRay pathRay{0, direction, &random};
      std::optional<Collision> met;
      way->collide({&pathRay, 1}, {&met, 1}, counts);
      if (!met) break;
      const glm::vec3 anywhere = test::anyDirection(random);
      const float length_radii = static_cast<float>(random.below(3)) * traverse_radii(*scene->cloth, *met);
      way->leave(0, *met, anywhere, length_radii);
      comparison.add(*way, event, anywhere, false);
      const glm::vec3 back = glm::normalize(0.3f * test::anyDirection(random) - direction);
      way->leave(0, *met, back, length_radii);
      comparison.add(*way, event, back, true);
      const FibreFrame frame(met->tangent);
      const auto scattered = bcsdf.sample(frame.toLocal(-direction), met->offset, random);
      direction = frame.toWorld(scattered.wi);
      way->leave(0, *met, direction, scattered.length_radii);
    }
  }
  const int runs = (LawComparison::kStrata + 1) * static_cast<int>(cases().size());
  const auto expectOneHalf = [runs](const test::SampledMean& seen) {
    EXPECT_TRUE(test::isWithinNoise(seen.mean(), 0.5, seen.standardError(), runs));
  };
  expectOneHalf(comparison.all());
  EXPECT_GT(comparison.ended(), paths);  // of the flights from every path's events
  EXPECT_LT(comparison.all().standardError(), 0.004);
  if (isNear) {
    EXPECT_GT(scene->cloth->fibres->made(), 0u);
  }
  for (size_t i = 0; i < comparison.strata().size(); ++i) {
    SCOPED_TRACE(testing::Message() << i / 2 << " fibres known" << (i % 2 ? ", on the way back" : ""));
    if (comparison.strata()[i].count() > 0) expectOneHalf(comparison.strata()[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, OneLaw, testing::ValuesIn(cases()), nameOf);

}  // namespace
}  // namespace loomlight
