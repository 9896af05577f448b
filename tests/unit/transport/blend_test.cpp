#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "render/media/fibre_medium.h"
#include "render/media/loomlight_medium.h"
#include "render/media/volume_medium.h"
#include "render/transport/path_integrator.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

Fabric blended(double share) {
  Fabric fabric = test::whiteCotton();
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(40.0f, 20.0f, 5.0f);
  for (Yarn& yarn : fabric.yarns) {
    yarn.blendFibre = 1;
    yarn.blendShare = share;
  }
  return fabric;
}

Image pictureOf(const Fabric& fabric) {
  constexpr int kWidth = 16, kHeight = 12;
  const auto scene = test::sceneOf(fabric);
  Film film(kWidth, kHeight);
  Task task;
  task.threads = 1;
  renderUpTo(2, *scene, VolumeMedium(scene->cloth), CameraRays(fabric.camera, kWidth, kHeight), film, task);
  return film.toImage(false);
}

void expectSame(const Image& a, const Image& b) {
  for (const char* channel : {"R", "G", "B"}) EXPECT_EQ(a.find(channel)->values, b.find(channel)->values);
}

TEST(Blend, OfNothingIsTheYarnsOwnFibre) {
  Fabric plain = blended(0);
  for (Yarn& yarn : plain.yarns) yarn.blendFibre.reset();
  expectSame(pictureOf(plain), pictureOf(blended(0)));
}

TEST(Blend, OfAllIsTheOtherFibre) {
  const auto scene = test::sceneOf(blended(1));
  Random random(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(drawMaterial(scene->cloth->yarns[0][0], random), 1);
}

TEST(Blend, LightMeetsEachKindAsOftenAsThereIs) {
  const auto scene = test::sceneOf(blended(0.3));
  constexpr int kDraws = 20000;
  Random random(1);
  int drawn = 0;
  for (int i = 0; i < kDraws; ++i) drawn += drawMaterial(scene->cloth->yarns[0][0], random) == 1;
  EXPECT_NEAR(drawn / static_cast<double>(kDraws), 0.3, 4 * std::sqrt(0.3 * 0.7 / kDraws));
}

/// The collisions of a path with a fibre that it had met just before the last one: how many, and how many of them were
/// with a fibre of another material, which a fibre cannot become.
class SameFibreAgain final : public PathSink {
 public:
  bool meets(const Collision& at, uint32_t event) override {
    // Tangents that statistics draw are never equal: the medium knows this fibre.
    if (event > 2 && at.tangent == before_.tangent && at.yarnId == before_.yarnId) {
      ++met;
      changed += at.material != before_.material;
    }
    before_ = last_;
    last_ = at;
    return true;
  }
  int met = 0, changed = 0;

 private:
  Collision last_, before_;
};

TEST(Blend, AFibreThatIsMetAgainIsOfTheKindThatItWas) {
  const auto scene = test::sceneOf(blended(0.5));
  const LoomlightMedium medium(scene->cloth);
  PathIntegrator integrator(*scene, medium, PathSampling::plain(64));
  Random random(1);
  TraceCounts counts;
  SameFibreAgain sink;
  for (int i = 0; i < 2000; ++i) {
    const float x = random.uniform() - 0.5f, y = random.uniform() - 0.5f;
    integrator.follow({{x, y, 1}, {0, 0, -1}}, random, sink, counts);
  }
  EXPECT_GT(sink.met, 200);
  EXPECT_EQ(sink.changed, 0);
}

// Whatever meets it, and as often: fibres that rays find keep what they are, and there are as many of each kind as the
// blend says.
TEST(Blend, AnExplicitFibreIsAlwaysOfOneKind) {
  const auto scene = test::sceneOf(blended(0.3));
  const auto fibres = FibreMedium::build(scene->cloth, {}, Task{});
  MediumPath path = fibres->path();
  Random random(1);
  TraceCounts counts;
  std::map<uint64_t, int> kinds;
  int again = 0;
  for (int i = 0; i < 20000; ++i) {
    const float x = random.uniform() - 0.5f, y = random.uniform() - 0.5f;
    path.begin({{x, y, 1}, -1});
    const auto met = path.collide({0, 0, -1}, random, counts);
    if (!met) continue;
    const auto [known, isNew] = kinds.emplace(met->fibre, met->material);
    EXPECT_EQ(known->second, met->material);
    again += !isNew;
  }
  EXPECT_GT(again, 1000);
  int other = 0;
  for (const auto& [fibre, material] : kinds) other += material == 1;
  const auto count = static_cast<double>(kinds.size());
  EXPECT_NEAR(other / count, 0.3, 4 * std::sqrt(0.3 * 0.7 / count));
}

}  // namespace
}  // namespace loomlight
