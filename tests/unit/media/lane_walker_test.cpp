#include "render/media/lane_walker.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <map>
#include <vector>

#include "render/media/known_lanes.h"
#include "render/media/loomlight_batch.h"
#include "render/optics/fibre_frame.h"
#include "tests/support/lone_walk.h"
#include "tests/support/test_cloth.h"
#include "tests/support/voxel_walk.h"

namespace loomlight {
namespace {

using test::ExtinctionAt;
using test::hasSeveralComponents;
using test::VoxelFibres;
using test::WalkEnd;

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

Rays raysOf(const Scene& scene, const LoomlightMedium& medium, int paths) {
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

struct Case {
  const char* name;
  DrapeKind drape;
  FibreLayout layout;
  int plies;
  int fibresPerPly = 0;  ///< 0: as many as the count takes
};

class LaneWalks : public testing::TestWithParam<Case> {
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

// Lanes take each ray as far as it would come alone, in doubles. Their floats put the faces of voxels elsewhere by some
// 1e-6 mm, which is less than a thousandth of a voxel: so a ray ends in another voxel, or passes where the other meets,
// only if its depth is used up as near to a face as that, and that is one ray in a thousand at the most.
void expectAsFarAsAlone(const std::shared_ptr<const Scene>& scene, LoomlightMedium::Ingredients ingredients) {
  const LoomlightMedium medium(scene->cloth, ingredients);
  const Rays all = raysOf(*scene, medium, 1500);
  LaneWalker walker(*scene->cloth, medium.walkRules());
  Ends lanes(*scene->cloth, all.rays.size());
  EXPECT_GT(walker.walk(all.rays, lanes), all.rays.size());
  EXPECT_TRUE(lanes.allToldOnce());
  const glm::vec3 size = scene->cloth->volume->grid().size_mm;
  const float near_mm = 0.01f * std::min({size.x, size.y, size.z});
  size_t met = 0, others = 0;
  for (size_t i = 0; i < all.rays.size(); ++i) {
    const WalkEnd alone = test::loneWalk(*scene->cloth, medium.walkRules(), all.rays[i]);
    const WalkEnd& lane = lanes.ends()[i];
    met += alone.met;
    const bool same = alone.met == lane.met && std::abs(alone.t_mm - lane.t_mm) <= near_mm &&
                      std::abs(alone.depth - lane.depth) <= 0.01f;
    others += !same;
  }
  EXPECT_GT(met, all.rays.size() / 4);
  EXPECT_LT(met, all.rays.size());
  EXPECT_LE(others, all.rays.size() / 1000) << "of " << all.rays.size();
}

TEST_P(LaneWalks, GoAsFarAsEachRayAlone) {
  expectAsFarAsAlone(scene(), {});
}
TEST_P(LaneWalks, GoAsFarAsEachRayAloneThroughThePlainVolume) {
  expectAsFarAsAlone(scene(), LoomlightMedium::plain(EventLaw::projected));
}

// What becomes of a ray does not depend on which others walk beside it, nor on how many fit into a register.
TEST_P(LaneWalks, AreTheSameInAnyCompanyAndOfAnyWidth) {
  const auto scene = this->scene();
  const LoomlightMedium medium(scene->cloth);
  const Rays all = raysOf(*scene, medium, 200);
  const auto together = [&] {
    LaneWalker walker(*scene->cloth, medium.walkRules());
    Ends ends(*scene->cloth, all.rays.size());
    walker.walk(all.rays, ends);
    return ends.ends();
  };
  const auto expectSame = [](const WalkEnd& a, const WalkEnd& b) {
    EXPECT_EQ(a.met, b.met);
    EXPECT_EQ(a.t_mm, b.t_mm);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.voxel, b.voxel);
  };
  const std::vector<WalkEnd> expected = together();
  LaneWalker walker(*scene->cloth, medium.walkRules());
  for (size_t i = 0; i < all.rays.size(); ++i) {
    Ends alone(*scene->cloth, 1);
    walker.walk({&all.rays[i], 1}, alone);
    expectSame(alone.ends()[0], expected[i]);
  }
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const std::vector<WalkEnd> ends = together();
    for (size_t i = 0; i < ends.size(); ++i) expectSame(ends[i], expected[i]);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
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

/// The extinction of all fibres of a voxel, each component's in the box that they lie in.
float wholeInBoxes(const TraceData& cloth, const VoxelContent& content, const FoundFibres& found, glm::vec3 direction) {
  const auto crowding = [](const VoxelFibres& component) { return component.box.crowding(); };
  return test::sumExtinction(cloth.yarns, content, found.drape, direction, crowding);
}

/// How many components of a voxel are at a place in it, and how many fill a part of it alone or all of it.
struct ComponentsAt {
  size_t there = 0, boxed = 0, whole = 0;
  ComponentsAt(const VoxelContent& content, glm::vec3 inVoxel) {
    for (int span = 0; span < content.count; ++span)
      for (const Component& component : content.spans[span].components) {
        there += component.box().contains(inVoxel) ? 1 : 0;
        (component.box() == VoxelBox() ? whole : boxed) += 1;
      }
  }
};

// A ray finds what the voxel holds, within what the lanes' table of I(alpha, s) is off.
TEST_P(LaneWalks, FindWhatIsInTheVoxel) {
  const auto scene = this->scene();
  const TraceData& cloth = *scene->cloth;
  FoundByPaths walked(*scene);
  auto& [medium, all, walker, ends] = walked;
  ASSERT_GT(ends.found().size(), 100u);
  size_t several = 0, boxed = 0, filled = 0;
  for (const FoundFibres& found : ends.found()) {
    VoxelContent content;
    walker.cells().bricksIn(found.cell).content(*cloth.volume, found.voxel, content);
    const float whole = wholeInBoxes(cloth, content, found, all.rays[found.ray].direction);
    EXPECT_NEAR(found.whole, whole, 1e-4f * whole);
    const ComponentsAt components(content, glm::vec3(0.5f));
    boxed += components.boxed;
    filled += components.whole;
    several += hasSeveralComponents(content) ? 1 : 0;
    if (hasSeveralComponents(content)) {
      EXPECT_EQ(found.component, FoundLanes::kSeveral);
    } else {
      const VoxelContent::YarnSpan& only = content.spans[0];
      const auto& brick = walker.cells().bricksIn(found.cell).bricks[static_cast<size_t>(found.slot)];
      EXPECT_EQ(cloth.volume->components() + found.component, &only.components[0]);
      EXPECT_EQ(YarnId(brick.system, brick.index), YarnId(only.system, only.index));
    }
  }
  EXPECT_GT(several, 0u);
  EXPECT_GT(boxed, 0u);
  EXPECT_GT(filled, 0u);
}

/// Whether a voxel's content has that component, of that yarn.
bool isAmong(const VoxelContent& content, const Component* wanted, YarnId yarn) {
  for (int span = 0; span < content.count; ++span)
    for (const Component& component : content.spans[span].components)
      if (&component == wanted) return YarnId{content.spans[span].system, content.spans[span].index} == yarn;
  return false;
}

// Who looks at a place finds the components in whose boxes it is, on every instruction set.
TEST_P(LaneWalks, LooksFindWhatIsAtAPlace) {
  const auto scene = this->scene();
  const TraceData& cloth = *scene->cloth;
  FoundByPaths walked(*scene);
  auto& [medium, all, walker, ends] = walked;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    Random random(21);
    size_t found = 0, nothing = 0;
    for (size_t first = 0; first + kWalkLanes <= ends.found().size(); first += kWalkLanes) {
      LookLanes looks{};
      std::array<glm::vec3, kWalkLanes> places;
      const auto foundIn = [&](size_t lane) -> const FoundFibres& { return ends.found()[first + lane]; };
      for (size_t lane = 0; lane < kWalkLanes; ++lane) {
        const FoundFibres& ray = foundIn(lane);
        places[lane] = {random.uniform(), random.uniform(), random.uniform()};
        looks.wanted[lane] = 1;
        for (int axis = 0; axis < 3; ++axis) {
          looks.direction[axis][lane] = all.rays[ray.ray].direction[axis];
          looks.voxel[axis][lane] = ray.voxel[axis];
          looks.inVoxel[axis][lane] = places[lane][axis];
          for (int column = 0; column < 3; ++column) looks.frame[column][axis][lane] = ray.drape.frame[column][axis];
        }
        looks.densityScale[lane] = ray.drape.densityScale;
        walker.cells().fill(ray.cell, looks.cell, lane);
      }
      look(walker.field(), looks);
      for (size_t lane = 0; lane < kWalkLanes; ++lane) {
        VoxelContent content;
        walker.cells().bricksIn(foundIn(lane).cell).content(*cloth.volume, foundIn(lane).voxel, content);
        const size_t there = ComponentsAt(content, places[lane]).there;
        const float whole = test::sumExtinction(cloth.yarns, content, foundIn(lane).drape,
                                                all.rays[foundIn(lane).ray].direction, ExtinctionAt{places[lane]});
        EXPECT_NEAR(looks.found.whole[lane], whole, 1e-4f * whole);
        const int32_t component = looks.found.component[lane];
        if (there == 1) {
          const auto slot = static_cast<size_t>(looks.found.slot[lane]);
          const auto& brick = walker.cells().bricksIn(foundIn(lane).cell).bricks[slot];
          ASSERT_GE(component, 0);
          EXPECT_TRUE(cloth.volume->components()[component].box().contains(places[lane]));
          EXPECT_TRUE(isAmong(content, cloth.volume->components() + component, {brick.system, brick.index}));
        } else {
          EXPECT_EQ(component, there == 0 ? FoundLanes::kNone : FoundLanes::kSeveral);
        }
        (there > 0 ? found : nothing) += 1;
      }
    }
    EXPECT_GT(found, 100u);
    EXPECT_GT(nothing, 0u);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// Where there are several, each is chosen as often as it counts, flights of before and the fibre that was left
// included.
TEST_P(LaneWalks, ChoicesAreInProportionToWhatCounts) {
  const auto scene = this->scene();
  const TraceData& cloth = *scene->cloth;
  const VoxelGrid grid{cloth.volume->grid().cell, cloth.volume->grid().size_mm, 0, 0};
  FoundByPaths walked(*scene);
  auto& [medium, all, walker, ends] = walked;
  Random random(22);
  size_t tried = 0, known = 0;
  for (const FoundFibres& found : ends.found()) {
    if (found.component != FoundLanes::kSeveral) continue;
    const DepthRay& ray = all.rays[found.ray];
    const glm::vec3 light = ray.from.world + found.t_mm * ray.direction;
    const glm::vec3 inVoxel(random.uniform(), random.uniform(), random.uniform());
    ChoiceLanes choices{};
    for (size_t lane = 0; lane < kWalkLanes; ++lane) {
      choices.wanted[lane] = 1;
      put(choices.direction, lane, ray.direction);
      put(choices.voxel, lane, found.voxel);
      put(choices.inVoxel, lane, inVoxel);
      for (int column = 0; column < 3; ++column) put(choices.frame[column], lane, found.drape.frame[column]);
      choices.densityScale[lane] = found.drape.densityScale;
      walker.cells().fill(found.cell, choices.cell, lane);
      const FibreInCloth before(ray.known->before, light, *cloth.shell, found.tet);
      putPastSegments(choices.known, lane, *ray.known, light);
      putBefore(choices.known.before, lane, ray.known->before, before);
      put(choices.known.before.axis_mm, lane, found.inCell_mm + before.toAxis_mm);
      choices.middle[lane] = found.toMiddle_mm;
    }
    std::map<const Component*, int> chosen;
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
      for (size_t lane = 0; lane < kWalkLanes; ++lane)
        choices.u[lane] = (static_cast<float>(round * kWalkLanes + lane) + 0.5f) / (kRounds * kWalkLanes);
      chooseComponents(walker.field(), choices);
      for (const int32_t component : choices.component) ++chosen[cloth.volume->components() + component];
    }

    VoxelContent content;
    walker.cells().bricksIn(found.cell).content(*cloth.volume, found.voxel, content);
    ShellSegment here;
    here.origin = light;
    here.clothOrigin = found.inCell_mm;
    const test::CorrelationState state(*ray.known, here, grid, medium.toClothOf(found.tet));
    const glm::vec3 middle = light + found.toMiddle_mm * ray.direction;
    std::vector<std::pair<const Component*, float>> weights;
    float sum = 0;
    for (int span = 0; span < content.count; ++span)
      for (const Component& component : content.spans[span].components) {
        const auto& yarn = content.spans[span];
        const YarnOptics& optics = cloth.yarns[static_cast<size_t>(yarn.system)][static_cast<size_t>(yarn.yarn)];
        const VoxelFibres fibres{test::inWorld(component.decode(), found.drape), component.box(), &optics, &yarn};
        const float left = state.share(fibres, middle, found.voxel);
        known += left < 0.99f ? 1 : 0;
        weights.emplace_back(&component, test::extinction(fibres.fibres, optics, ray.direction) *
                                             ExtinctionAt{inVoxel}(fibres)*std::max(1e-6f, left));
        sum += weights.back().second;
      }
    if (!(sum > 0)) continue;
    ++tried;
    // Numbers spaced evenly: each stretch of [0, 1) in which one component is chosen holds one more or less than its
    // share, and the last of n components is chosen in 2^(n - 2) of them.
    const double most = std::exp2(static_cast<double>(weights.size()) - 2) + 0.5;
    for (const auto& [component, weight] : weights)
      EXPECT_NEAR(chosen[component], kRounds * kWalkLanes * weight / sum, most) << weights.size();
  }
  EXPECT_GT(tried, 20u);
  EXPECT_GT(known, 5u);
}

INSTANTIATE_TEST_SUITE_P(Cloths, LaneWalks,
                         testing::Values(Case{"flat", DrapeKind::flat, FibreLayout::packed, 1},
                                         Case{"plied", DrapeKind::flat, FibreLayout::packed, 2},
                                         Case{"atRandom", DrapeKind::flat, FibreLayout::random, 2},
                                         Case{"bent", DrapeKind::cylinder, FibreLayout::packed, 2},
                                         Case{"folded", DrapeKind::folds, FibreLayout::packed, 1},
                                         Case{"fine", DrapeKind::flat, FibreLayout::packed, 1, 500},
                                         Case{"fineOnFolds", DrapeKind::folds, FibreLayout::packed, 2, 300}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace loomlight
