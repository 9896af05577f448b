#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "render/media/known_lanes.h"
#include "tests/support/lane_walks.h"
#include "tests/support/voxel_walk.h"

namespace loomlight {
namespace {

using test::ExtinctionAt;
using test::FoundByPaths;
using test::hasSeveralComponents;
using test::VoxelFibres;

class LanePlaces : public test::LaneClothTest {};

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
TEST_P(LanePlaces, FindWhatIsInTheVoxel) {
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

/// A place of the voxel in which a ray has found something.
void wantPlace(FoundByPaths& walked, const FoundFibres& found, glm::vec3 inVoxel, VoxelPlaceLanes& lanes, size_t lane) {
  lanes.wanted[lane] = 1;
  put(lanes.direction, lane, walked.all.rays[found.ray].direction);
  put(lanes.voxel, lane, found.voxel);
  put(lanes.inVoxel, lane, inVoxel);
  for (int column = 0; column < 3; ++column) put(lanes.frame[column], lane, found.drape.frame[column]);
  lanes.densityScale[lane] = found.drape.densityScale;
  walked.walker.cells().fill(found.cell, lanes.cell, lane);
}

// Who looks at a place finds the components in whose boxes it is, on every instruction set.
TEST_P(LanePlaces, LooksFindWhatIsAtAPlace) {
  const auto scene = this->scene();
  const TraceData& cloth = *scene->cloth;
  FoundByPaths walked(*scene);
  auto& [medium, all, walker, ends] = walked;
  test::onEveryInstructionSet([&] {
    Random random(21);
    size_t found = 0, nothing = 0;
    for (size_t first = 0; first + kWalkLanes <= ends.found().size(); first += kWalkLanes) {
      LookLanes looks{};
      std::array<glm::vec3, kWalkLanes> places;
      const auto foundIn = [&](size_t lane) -> const FoundFibres& { return ends.found()[first + lane]; };
      for (size_t lane = 0; lane < kWalkLanes; ++lane) {
        const FoundFibres& ray = foundIn(lane);
        places[lane] = {random.uniform(), random.uniform(), random.uniform()};
        wantPlace(walked, ray, places[lane], looks, lane);
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
  });
}

/// Of a ray that has found several components, the one that it meets at a place of their voxel, drawn with u.
void wantChoice(FoundByPaths& walked, const TraceData& cloth, const FoundFibres& found, glm::vec3 inVoxel, float u,
                ChoiceLanes& choices, size_t lane) {
  const DepthRay& ray = walked.all.rays[found.ray];
  const glm::vec3 light = ray.from.world + found.t_mm * ray.direction;
  wantPlace(walked, found, inVoxel, choices, lane);
  choices.u[lane] = u;
  const FibreInCloth before(ray.known->before, light, *cloth.shell, found.tet);
  putPastSegments(choices.known, lane, *ray.known, light);
  putBefore(choices.known.before, lane, ray.known->before, before);
  put(choices.known.before.axis_mm, lane, found.inCell_mm + before.toAxis_mm);
  choices.middle_mm[lane] = found.toMiddle_mm;
}

/// What a ray may meet where it has found several components, one ray in plain numbers: what each counts.
struct Countable {
  const Component* component;
  YarnId yarn;
  float weight = 0;
};
std::vector<Countable> countables(FoundByPaths& walked, const TraceData& cloth, const FoundFibres& found,
                                  glm::vec3 inVoxel, size_t& known) {
  const DepthRay& ray = walked.all.rays[found.ray];
  VoxelContent content;
  walked.walker.cells().bricksIn(found.cell).content(*cloth.volume, found.voxel, content);
  ShellSegment here;
  here.origin = ray.from.world + found.t_mm * ray.direction;
  here.clothOrigin = found.inCell_mm;
  const VoxelGrid grid{cloth.volume->grid().cell, cloth.volume->grid().size_mm, 0, 0};
  const test::CorrelationState state(*ray.known, here, grid, walked.medium.toClothOf(found.tet));
  const glm::vec3 middle = here.origin + found.toMiddle_mm * ray.direction;
  std::vector<Countable> all;
  for (int span = 0; span < content.count; ++span)
    for (const Component& component : content.spans[span].components) {
      const VoxelContent::YarnSpan& yarn = content.spans[span];
      const YarnOptics& optics = cloth.yarns[static_cast<size_t>(yarn.system)][static_cast<size_t>(yarn.yarn)];
      const VoxelFibres fibres{test::inWorld(component.decode(), found.drape), component.box(), &optics, &yarn};
      const float left = state.share(fibres, middle, found.voxel), there = ExtinctionAt{inVoxel}(fibres);
      known += left < 0.99f ? 1 : 0;
      all.push_back({&component, fibres.yarnId(),
                     test::extinction(fibres.fibres, optics, ray.direction) * there * std::max(1e-6f, left)});
    }
  return all;
}

// Where there are several, each is chosen as often as it counts, flights of before and the fibre that was left
// included.
TEST_P(LanePlaces, ChoicesAreInProportionToWhatCounts) {
  const auto scene = this->scene();
  const TraceData& cloth = *scene->cloth;
  FoundByPaths walked(*scene);
  Random random(22);
  size_t tried = 0, known = 0;
  for (const FoundFibres& found : walked.ends.found()) {
    if (found.component != FoundLanes::kSeveral) continue;
    const glm::vec3 inVoxel(random.uniform(), random.uniform(), random.uniform());
    const std::vector<Countable> all = countables(walked, cloth, found, inVoxel, known);
    float sum = 0;
    for (const Countable& one : all) sum += one.weight;
    if (!(sum > 0)) continue;
    ++tried;
    std::map<const Component*, int> chosen;
    constexpr int kDraws = 1024;
    const auto& bricks = walked.walker.cells().bricksIn(found.cell).bricks;
    ChoiceLanes choices{};
    for (int first = 0; first < kDraws; first += kWalkLanes) {
      for (size_t lane = 0; lane < kWalkLanes; ++lane) {
        const float u = (static_cast<float>(first) + static_cast<float>(lane) + 0.5f) / kDraws;
        wantChoice(walked, cloth, found, inVoxel, u, choices, lane);
      }
      chooseComponents(walked.walker.field(), choices);
      for (size_t lane = 0; lane < kWalkLanes; ++lane) {
        const Component* component = cloth.volume->components() + choices.component[lane];
        ++chosen[component];
        const auto& brick = bricks[static_cast<size_t>(choices.slot[lane])];
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Countable& one) {
          return one.component == component && one.yarn == YarnId{brick.system, brick.index};
        }));
      }
    }
    // Numbers spaced evenly: each stretch of [0, 1) in which one component is chosen holds one more or less than its
    // share, and the last of n components is chosen in 2^(n - 2) of them. What lanes read of the table I(alpha, s) is
    // off by 1e-5, which is a hundredth of a draw; rounding has no more.
    const double most = std::exp2(static_cast<double>(all.size()) - 2) + 0.1;
    for (const Countable& one : all) EXPECT_NEAR(chosen[one.component], kDraws * one.weight / sum, most) << all.size();
  }
  EXPECT_GT(tried, 20u);
  EXPECT_GT(known, 5u);
}

// What is chosen for a ray does not depend on which others are beside it, nor on how many fit into a register.
TEST_P(LanePlaces, ChoicesAreTheSameInAnyCompanyAndOfAnyWidth) {
  const auto scene = this->scene();
  const TraceData& cloth = *scene->cloth;
  FoundByPaths walked(*scene);
  Random random(23);
  ChoiceLanes together{};
  size_t count = 0;
  for (const FoundFibres& found : walked.ends.found()) {
    if (found.component != FoundLanes::kSeveral || count == kWalkLanes) continue;
    const glm::vec3 inVoxel(random.uniform(), random.uniform(), random.uniform());
    wantChoice(walked, cloth, found, inVoxel, random.uniform(), together, count++);
  }
  ASSERT_EQ(count, kWalkLanes);
  ChoiceLanes first = together;
  chooseComponents(walked.walker.field(), first);
  test::onEveryInstructionSet([&] {
    ChoiceLanes again = together;
    chooseComponents(walked.walker.field(), again);
    EXPECT_EQ(again.component, first.component);
    EXPECT_EQ(again.slot, first.slot);
    for (size_t lane = 0; lane < kWalkLanes; ++lane) {
      ChoiceLanes alone = together;
      alone.wanted.fill(0);
      alone.wanted[lane] = 1;
      chooseComponents(walked.walker.field(), alone);
      EXPECT_EQ(alone.component[lane], first.component[lane]);
      EXPECT_EQ(alone.slot[lane], first.slot[lane]);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Cloths, LanePlaces, testing::ValuesIn(test::laneCloths()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace loomlight
