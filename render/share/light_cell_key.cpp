#include "render/share/light_cell_key.h"

#include <algorithm>
#include <cmath>

#include "core/base/hash.h"
#include "core/base/modulo.h"
#include "core/base/units.h"
#include "render/media/shell_walk.h"
#include "render/scene/thread_shade.h"

// How it works. A key is a hash that grows from level to level: yarn, fibre and the side seen; then edges near by and
// how the cloth lies; then the crossings around and a block of voxels; then the voxel. The key as it stands at each
// level names the cell of that level, so a cell's parent is known without a search. How the cloth lies is cut into
// steps, with a jitter that blurs the borders between them; from where it is seen follows from that, as near as a
// picture's own directions are to one another.

namespace loomlight {
namespace {

/// In steps about whole numbers, not between them: most drapes have normals without any part along one axis, and jitter
/// would take half of these to a step that no path comes from.
int stepOf(float x, float jitter) {
  return static_cast<int>(std::floor(x + 0.5f + jitter));
}

/// How a sheet lies whose normal is n, and which way its u runs: rotated from lying flat by the shortest way, and then
/// about its normal. In steps of some 14 degrees of the normal (an equal-area map of the sphere, whose only tear is
/// where it points straight down) and twice as much of the other.
uint64_t lieBin(glm::vec3 u, glm::vec3 n, glm::vec2 jitter) {
  constexpr float kSteps = 4;     // per radian
  constexpr int kTurnSteps = 12;  // all around
  const float up = std::max(1e-6f, 1 + n.z);
  const glm::vec2 map = glm::vec2(n) * std::sqrt(2 / up);  // of Lambert, as long as the chord
  // The x and y axes, rotated like z to n.
  const glm::vec3 x(1 - n.x * n.x / up, -n.x * n.y / up, -n.x), y(-n.x * n.y / up, 1 - n.y * n.y / up, -n.y);
  const float turn = std::atan2(glm::dot(u, y), glm::dot(u, x)) / static_cast<float>(2 * kPi);
  const float third = glm::fract(jitter.x + jitter.y + 0.5f) - 0.5f;  // as even as either, and independent of it
  return hashCombine(
      hashCombine(mixBits(static_cast<uint64_t>(stepOf(kSteps * map.x, jitter.x))), stepOf(kSteps * map.y, jitter.y)),
      wrap(stepOf(kTurnSteps * turn, third), kTurnSteps));
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
    : cloth_(*scene.cloth), geometry_(scene.cloth->volume->geometry()), lightIsNear_(isNear(scene.fabric->light)) {
  const YarnTable& yarns = geometry_.yarns();
  isSpaced_ = yarns.threads(System::warp).farthest_mm() > 0 || yarns.threads(System::weft).farthest_mm() > 0;
}

uint64_t LightCellKeys::crossingsAround(int pick, int end) const {
  uint64_t warpOver = 0, key = 0;
  for (int p = pick - 1; p <= pick + 1; ++p)
    for (int e = end - 1; e <= end + 1; ++e) warpOver = 2 * warpOver + (geometry_.weave().warpOver(p, e) ? 1 : 0);
  key = hashCombine(key, warpOver);
  for (int i = -1; i <= 1; ++i) {
    key = hashCombine(key, geometry_.yarnIndex(System::warp, end + i));
    key = hashCombine(key, geometry_.yarnIndex(System::weft, pick + i));
    if (!isSpaced_) continue;
    key = hashCombine(key, geometry_.codes().kind(System::warp, end + i));
    key = hashCombine(key, geometry_.codes().kind(System::weft, pick + i));
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

  const LocalDrape drape = LocalDrape::at(shell, first.place.tet, first.place.world);
  const glm::vec3 n = drape.normal();  // and not the collision's: an explicit fibre has one of its own
  uint64_t lie = drape.isometric ? 0 : lieBin(glm::normalize(drape.frame[0]), n, jitter);
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
  key = hashCombine(key, glm::dot(first.incoming, n) > 0 ? 1 : 0);  // the back is seen
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
