#include "render/share/light_cell_key.h"

#include <algorithm>
#include <cmath>

#include "core/base/hash.h"
#include "render/scene/thread_shade.h"

// How it works. A key is a hash that grows from level to level: yarn, fibre and the side seen; then edges near by and
// how the cloth lies; then the crossings around and a block of voxels; then the voxel. The key as it stands at each
// level names the cell of that level, so a cell's parent is known without a search. Directions are cut into bins on a
// cube, with a jitter that blurs the borders between bins.

namespace loomlight {
namespace {

/// Which axis a direction is nearest to, and from which side: 0..5.
uint32_t sideOf(glm::vec3 d) {
  const glm::vec3 a = glm::abs(d);
  const int axis = a.z >= a.x && a.z >= a.y ? 2 : a.y >= a.x ? 1 : 0;
  return static_cast<uint32_t>(2 * axis + (d[axis] < 0 ? 1 : 0));
}

/// A unit vector in steps of 1 / `steps` along each axis of the cube that it goes through.
uint64_t directionBin(glm::vec3 d, float steps, glm::vec2 jitter) {
  const uint32_t side = sideOf(d);
  const int axis = static_cast<int>(side / 2);
  const float scale = steps / std::max(1e-6f, std::abs(d[axis]));
  const glm::vec2 across(d[(axis + 1) % 3], d[(axis + 2) % 3]);
  const glm::ivec2 bin(glm::floor(across * scale + jitter));
  return hashCombine(hashCombine(mixBits(side), bin.x), bin.y);
}

/// The eye carries this lamp, so that places in one voxel of a repeat do not look alike.
bool isNear(const Light& light) {
  return light.kind == LightKind::headlight;
}

/// What LightCellKeys::of() asks of a yarn, beside its number.
bool sameInKeys(const Yarn& a, const Yarn& b) {
  return a.fibre == b.fibre && a.blendFibre == b.blendFibre && a.blendShare == b.blendShare &&
         (a.shadeVariation_percent > 0) == (b.shadeVariation_percent > 0);
}

}  // namespace

bool sameLightCells(const Fabric& before, const Fabric& after) {
  return isNear(before.light) == isNear(after.light) && std::ranges::equal(before.yarns, after.yarns, sameInKeys);
}

LightCellKeys::LightCellKeys(const Scene& scene)
    : cloth_(*scene.cloth), geometry_(scene.cloth->volume->geometry()), lightIsNear_(isNear(scene.fabric->light)) {}

uint64_t LightCellKeys::crossingsAround(int pick, int end) const {
  uint64_t warpOver = 0, key = 0;
  for (int p = pick - 1; p <= pick + 1; ++p)
    for (int e = end - 1; e <= end + 1; ++e) warpOver = 2 * warpOver + (geometry_.weave().warpOver(p, e) ? 1 : 0);
  key = hashCombine(key, warpOver);
  for (int i = -1; i <= 1; ++i) {
    key = hashCombine(key, geometry_.yarnIndex(System::warp, end + i));
    key = hashCombine(key, geometry_.yarnIndex(System::weft, pick + i));
  }
  return key;
}

/// Which cut edges are at most two yarns away.
uint64_t LightCellKeys::edges(int pick, int end) const {
  constexpr int kNear = 2;
  return (end < kNear ? 1u : 0u) + (end >= geometry_.ends() - kNear ? 2u : 0u) + (pick < kNear ? 4u : 0u) +
         (pick >= geometry_.picks() - kNear ? 8u : 0u);
}

LightCellPath LightCellKeys::of(const Collision& first, glm::vec2 jitter) {
  const Shell& shell = *cloth_.shell;
  const glm::vec3 place = shell.toCloth(first.place.tet, first.place.world);
  const VoxelGrid& grid = cloth_.volume->grid();
  const glm::ivec3 voxel(glm::floor((place - glm::vec3(0, 0, grid.zLower_mm)) / grid.size_mm));
  const glm::ivec3 inCell = voxel - glm::ivec3(first.end, first.pick, 0) * grid.cell;
  if (first.pick != pick_ || first.end != end_) {
    pick_ = first.pick;
    end_ = first.end;
    around_ = crossingsAround(pick_, end_);
  }

  glm::vec3 toEye = -first.incoming;
  uint64_t lie = 0;
  if (!shell.isFlat()) {
    constexpr float kSteps = 4;
    const glm::mat3 frame = shell.frame(first.place.tet, first.place.world);
    const glm::vec3 u = glm::normalize(frame[0]), v = glm::normalize(frame[1]);
    const glm::vec3 n = glm::normalize(glm::cross(frame[0], frame[1]));  // an explicit fibre has a normal of its own
    toEye = {glm::dot(toEye, u), glm::dot(toEye, v), glm::dot(toEye, n)};
    lie = hashCombine(directionBin(n, kSteps, jitter), sideOf(u));
  }
  if (lightIsNear_) {
    constexpr float kPatch_mm = 4;
    const glm::ivec2 patch(glm::floor(glm::vec2(place) / kPatch_mm + jitter));
    lie = hashCombine(hashCombine(lie, patch.x), patch.y);
  }

  LightCellPath path;
  uint64_t key = 0;
  const auto level = [&](uint64_t i) { path.keys[i] = (key & ~kLightCellLevelMask) | i; };
  level(0);
  key = hashCombine(hashCombine(hashCombine(key, static_cast<int>(first.yarnId.system)), first.yarn), first.material);
  key = hashCombine(key, sideOf(toEye));
  if (first.optics.shadeVariation > 0) key = hashCombine(key, shadeClass(first.yarnId.system, first.yarnId.index));
  level(1);
  key = hashCombine(hashCombine(key, edges(first.pick, first.end)), lie);
  level(2);
  const glm::ivec3 block = inCell >> 2;
  key = hashCombine(hashCombine(hashCombine(hashCombine(key, around_), block.x), block.y), block.z);
  level(3);
  key = hashCombine(hashCombine(hashCombine(key, inCell.x), inCell.y), inCell.z);
  level(4);
  return path;
}

}  // namespace loomlight
