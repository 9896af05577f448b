#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "render/media/loomlight_batch.h"
#include "render/optics/fibre_frame.h"
#include "tests/support/lone_walk.h"
#include "tests/support/test_cloth.h"

namespace loomlight::test {

/// Keeps how each ray ends.
class Ends final : public DepthRayEnds {
 public:
  Ends(const TraceData& cloth, size_t rays) : perCell_(cloth.volume->grid().cell), ends_(rays), told_(rays) {}
  FoundFibres& found(size_t ray) override {
    ++told_[ray];
    return found_.emplace_back();
  }
  void left(size_t ray, float depth, int) override {
    ++told_[ray];
    ends_[ray] = {false, 0, depth, {}};
  }
  const std::vector<WalkEnd>& ends() {
    for (const FoundFibres& found : found_)
      ends_[found.ray] = {true, found.t_mm, 0, found.cell * perCell_ + found.voxel};
    return ends_;
  }
  const std::vector<FoundFibres>& found() const { return found_; }
  bool allToldOnce() const {
    return std::all_of(told_.begin(), told_.end(), [](int times) { return times == 1; });
  }

 private:
  glm::ivec3 perCell_;
  std::vector<FoundFibres> found_;
  std::vector<WalkEnd> ends_;
  std::vector<int> told_;
};

/// Flights and shadow rays as paths come to them: from the eye, and from inside the cloth with fibres in mind. Some
/// have a clear way at first.
struct Rays {
  std::vector<DepthRay> rays;
  std::vector<std::unique_ptr<KnownFibres>> known;
};

inline Rays raysOf(const Scene& scene, const LoomlightMedium& medium, int paths) {
  const CameraRays camera(scene.fabric->camera, 64, 64);
  LoomlightBatch batch(medium, 1);
  Random random(11);
  TraceCounts counts;
  Rays all;
  const auto add = [&](glm::vec3 direction, float tMax) {
    all.known.push_back(std::make_unique<KnownFibres>(batch.known(0)));
    const float depth = -std::log(1 - random.uniform());
    const float clear = all.rays.size() % 3 == 0 ? 0.15f * random.uniform() : 0.0f;
    all.rays.push_back({batch.place(0), direction, tMax, depth, all.known.back().get(), clear});
  };
  for (int i = 0; i < paths; ++i) {
    const float x = 64 * random.uniform(), y = 64 * random.uniform();
    const Ray ray = camera.ray(x, y);
    batch.begin(0, {ray.origin, -1}, {});
    glm::vec3 direction = ray.direction;
    for (int event = 0; event < 4; ++event) {
      add(direction, std::numeric_limits<float>::infinity());
      const PathRay pathRay{0, direction, &random};
      std::optional<Collision> met;
      batch.collide({&pathRay, 1}, {&met, 1}, counts);
      if (!met) break;
      const FibreFrame frame(met->tangent);
      const auto scattered = scene.cloth->materials[0].bcsdf->sample(frame.toLocal(-direction), met->offset, random);
      direction = frame.toWorld(scattered.wi);
      batch.leave(0, *met, direction, scattered.order);
      add(direction, 0.3f * random.uniform());
    }
  }
  return all;
}

/// Does it by each instruction set that this machine has and lanes are compiled for.
template <class Visit>
void onEveryInstructionSet(const Visit& visit) {
  const auto choose = [](int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    choose(target);
    visit();
  }
  choose(0);
}

/// A cloth through which lanes walk.
struct LaneCloth {
  const char* name;
  DrapeKind drape;
  FibreLayout layout;
  int plies;
  int fibresPerPly = 0;  ///< 0: as many as the count takes
};

class LaneClothTest : public testing::TestWithParam<LaneCloth> {
 protected:
  std::shared_ptr<const Scene> scene() const {
    Fabric fabric = test::whiteCotton();
    fabric.yarns[0].layout = GetParam().layout;
    fabric.yarns[0].plies = GetParam().plies;
    if (GetParam().fibresPerPly > 0) fabric.yarns[0].fibresPerPly = GetParam().fibresPerPly;
    fabric.drape.kind = GetParam().drape;
    fabric.drape.radius_mm = 4;
    return test::sceneOf(fabric);
  }
};

inline const std::vector<LaneCloth>& laneCloths() {
  static const std::vector<LaneCloth> all{LaneCloth{"flat", DrapeKind::flat, FibreLayout::packed, 1},
                                          LaneCloth{"plied", DrapeKind::flat, FibreLayout::packed, 2},
                                          LaneCloth{"atRandom", DrapeKind::flat, FibreLayout::random, 2},
                                          LaneCloth{"bent", DrapeKind::cylinder, FibreLayout::packed, 2},
                                          LaneCloth{"folded", DrapeKind::folds, FibreLayout::packed, 1},
                                          LaneCloth{"fine", DrapeKind::flat, FibreLayout::packed, 1, 500},
                                          LaneCloth{"fineOnFolds", DrapeKind::folds, FibreLayout::packed, 2, 300}};
  return all;
}

/// What the rays of 1500 paths have found.
struct FoundByPaths {
  explicit FoundByPaths(const Scene& scene)
      : medium(scene.cloth),
        all(raysOf(scene, medium, 1500)),
        walker(*scene.cloth, medium.walkRules()),
        ends(*scene.cloth, all.rays.size()) {
    walker.walk(all.rays, ends);
  }
  LoomlightMedium medium;
  Rays all;
  LaneWalker walker;
  Ends ends;
};

}  // namespace loomlight::test
