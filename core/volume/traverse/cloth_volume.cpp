#include "core/volume/traverse/cloth_volume.h"

#include <fmt/format.h>

#include <atomic>
#include <map>
#include <new>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"

// How it works. A volume is built in two steps. The tile map says which kind of brick (shape, phase and stretch of a
// yarn's cell) each cell has; after an edit of the weave it is that of the volume before with the changed crossings
// read anew (editTiles), else it is read from the codes of all cells (readTiles). Then the kinds without a brick get
// theirs: from the volume before where kind and yarn are equal (reuseBricks), else from their strands, in parallel,
// those in view first (makeBricks). A volume that is shown on the way lends missing kinds the brick of another phase or
// stretch (completed).

namespace loomlight {
namespace {

/// What is made beside a volume that it comes out of shares that one's pool of bricks. Where there is no room in it for
/// both, it is made alone, in a pool of its own.
template <class Make>
std::shared_ptr<const ClothVolume> besideOrAlone(const ClothVolume* previous, const Make& make) {
  if (!previous) return make(nullptr);
  try {
    return make(previous);
  } catch (const std::bad_alloc&) {
    return make(nullptr);
  }
}

}  // namespace

ClothVolume::ClothVolume(std::shared_ptr<const ClothGeometry> geometry, VoxelGrid grid, std::shared_ptr<BrickPool> pool)
    : geometry_(std::move(geometry)),
      grid_(grid),
      pool_(std::move(pool)),
      blocks_(pool_->blocks()),
      components_(pool_->components()),
      blocksPerCell_((grid.perCell() + 3) >> 2) {
  cells_ = {geometry_->ends(), geometry_->picks(), 1};
  cell_mm_ = {geometry_->warpPitch_mm(), geometry_->weftPitch_mm(), -2.0 * grid_.zLower_mm};
  voxel_mm_ = cell_mm_ / glm::dvec3(grid_.cell);
  perCell_ = 1.0 / cell_mm_;
  perVoxel_ = 1.0 / voxel_mm_;
}

std::shared_ptr<ClothVolume> ClothVolume::begin(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                const Task& task, const ClothVolume* previous) {
  const VoxelGrid grid = makeGrid(*geometry, resolution);
  auto pool = previous && previous->grid_ == grid ? previous->pool_ : std::make_shared<BrickPool>(grid.perCell());
  std::shared_ptr<ClothVolume> volume(new ClothVolume(std::move(geometry), grid, std::move(pool)));
  if (!previous || !volume->editTiles(*previous, task)) volume->readTiles(previous, task);
  return task.stopped() ? nullptr : volume;
}

std::shared_ptr<const ClothVolume> ClothVolume::build(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                      const Task& task, const ClothVolume* previous,
                                                      const PreviewSink* look) {
  const auto make = [&](const ClothVolume* reused) -> std::shared_ptr<const ClothVolume> {
    const auto volume = begin(geometry, resolution, task, reused);
    if (!volume) return nullptr;
    const Wanted wanted = volume->wanted(look ? look->inView : CellRect{});
    const std::span<const MissingBrick> bricks = wanted.bricks;
    size_t done = 0;
    for (const size_t stage : {wanted.sketch, wanted.seen, bricks.size()}) {
      if (stage == done || (!look && stage < bricks.size())) continue;
      if (!volume->makeBricks(bricks.subspan(done, stage - done), done, bricks.size(), task)) return nullptr;
      done = stage;
      if (look && done < bricks.size() && look->wanted(static_cast<double>(done) / static_cast<double>(bricks.size())))
        look->show(volume->completed());
    }
    volume->bricksVoxelised_ = done;
    return volume;
  };
  return besideOrAlone(previous, make);
}

std::shared_ptr<const ClothVolume> ClothVolume::sketch(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                       const CellRect& inView, const Task& task,
                                                       const ClothVolume* previous) {
  const auto make = [&](const ClothVolume* reused) -> std::shared_ptr<const ClothVolume> {
    const auto volume = begin(geometry, resolution, task, reused);
    if (!volume) return nullptr;
    const Wanted wanted = volume->wanted(inView);
    if (!volume->makeBricks(std::span(wanted.bricks).first(wanted.sketch), 0, wanted.bricks.size(), task))
      return nullptr;
    return volume->completed();
  };
  return besideOrAlone(previous, make);
}

std::shared_ptr<const ClothVolume> ClothVolume::atLevel(int level, const Task& task) const {
  const VoxelGrid grid = grid_.atLevel(level);
  std::shared_ptr<ClothVolume> volume(new ClothVolume(geometry_, grid, std::make_shared<BrickPool>(grid.perCell())));
  volume->tiles_ = tiles_;
  for (TileMap& tiles : volume->tiles_) tiles.dropBricks(volume->pool_);
  const Wanted wanted = volume->wanted(CellRect{});
  return volume->makeBricks(wanted.bricks, 0, wanted.bricks.size(), task) ? volume : nullptr;
}

std::shared_ptr<const ClothVolume> ClothVolume::completed() const {
  std::shared_ptr<ClothVolume> copy(new ClothVolume(geometry_, grid_, pool_));
  copy->tiles_ = tiles_;
  for (TileMap& tiles : copy->tiles_) tiles.standIn();
  return copy;
}

void ClothVolume::readTiles(const ClothVolume* previous, const Task& task) {
  for (size_t system = 0; system < tiles_.size() && !task.stopped(); ++system) {
    tiles_[system] = TileMap(*geometry_, static_cast<System>(system), pool_, task);
    if (previous) tiles_[system].shareRows(previous->tiles_[system]);
  }
  if (previous && !task.stopped()) reuseBricks(*previous);
}

bool ClothVolume::editTiles(const ClothVolume& previous, const Task& task) {
  const ClothGeometry& before = *previous.geometry_;
  auto names = geometry_->yarns().namesOfKinds(before.yarns());
  if (!names || previous.tiles_[0].isWorn() || previous.tiles_[1].isWorn()) return false;
  const Weave& weave = geometry_->weave();
  const size_t crossings = static_cast<size_t>(weave.ends()) * static_cast<size_t>(weave.picks());
  // To read a crossing anew in an edit costs some fifty times what it costs in a whole repeat, and where threads crowd
  // the yarns beside are read too.
  const size_t few = crossings / (geometry_->codes().crowded() ? 3 * 64 : 64);
  auto changed = weaveChanges(before.weave(), weave, std::max<size_t>(64, few));
  if (!changed) return false;
  const TileMap::Change change{before, geometry_->differsInWeaveOnly(before), std::move(*names), std::move(*changed)};
  const bool weaveOnly = grid_ == previous.grid_ && change.inWeaveAlone;
  tiles_ = previous.tiles_;
  for (TileMap& tiles : tiles_) {
    if (!weaveOnly) tiles.dropBricks(pool_);
    tiles.edit(*geometry_, change, task);
  }
  if (!weaveOnly && !task.stopped()) reuseBricks(previous);
  return true;
}

void ClothVolume::reuseBricks(const ClothVolume& previous) {
  if (previous.grid_ != grid_) return;
  for (size_t system = 0; system < tiles_.size(); ++system) {
    TileMap& tiles = tiles_[system];
    const TileMap& old = previous.tiles_[system];
    std::unordered_map<YarnCellKey, uint32_t, YarnCellKeyHash> oldShapes;
    for (uint32_t i = 0; i < old.shapes().size(); ++i) oldShapes.emplace(old.shapes()[i], i);
    // The same yarn may have another class in another fabric.
    std::map<int, std::optional<int>> oldYarns;
    for (const TileMap::Kind kind : tiles.missing()) {
      YarnCellKey key = tiles.shapes()[kind.shape];
      const auto [entry, isNew] = oldYarns.try_emplace(key.yarn);
      if (isNew) {
        const YarnGeometry& yarn = geometry_->yarn(key.system, key.yarn);
        for (const YarnCellKey& shape : old.shapes())
          if (previous.geometry_->yarn(key.system, shape.yarn) == yarn) entry->second = shape.yarn;
      }
      if (!entry->second) continue;
      key.yarn = *entry->second;
      const auto found = oldShapes.find(key);
      if (found == oldShapes.end()) continue;
      if (const auto brick = old.brick({found->second, kind.phase, kind.stretch})) tiles.place(kind, brick);
    }
  }
}

ClothVolume::Wanted ClothVolume::wanted(const CellRect& inView) {
  std::array<TileMap::Wanted, 2> of{tiles_[0].missing(inView), tiles_[1].missing(inView)};
  Wanted all;
  const auto add = [&](size_t TileMap::Wanted::* from, size_t TileMap::Wanted::* to) {
    for (size_t system = 0; system < of.size(); ++system) {
      const size_t first = from ? of[system].*from : 0, end = to ? of[system].*to : of[system].kinds.size();
      for (size_t i = first; i < end; ++i) all.bricks.push_back({&tiles_[system], of[system].kinds[i]});
    }
    return all.bricks.size();
  };
  all.sketch = add(nullptr, &TileMap::Wanted::sketch);
  all.seen = add(&TileMap::Wanted::sketch, &TileMap::Wanted::seen);
  add(&TileMap::Wanted::seen, nullptr);
  return all;
}

bool ClothVolume::makeBricks(std::span<const MissingBrick> bricks, size_t done, size_t all, const Task& task) {
  BrickList made(pool_, bricks.size());
  // One voxeliser for each thread: they keep their memory from brick to brick.
  std::atomic<size_t> bytes{brickBytes()}, next{0}, finished{done};
  const size_t workers = std::min<size_t>(bricks.size(), task.threads > 0 ? task.threads : hardwareThreads());
  parallelFor(workers, task.threads, [&](size_t) {
    Voxeliser voxelise(grid_);
    for (size_t i = next++; i < bricks.size() && !task.stopped(); i = next++) {
      const YarnCellKey key = bricks[i].tiles->key(bricks[i].kind);
      made.takeOver(i, pool_->add(voxelise(geometry_->strands(key), key.system), key.system));
      if ((bytes += (*pool_)[made[i]].bytes()) > kMaxBytes)
        throw InputError(
            fmt::format("the volume of this cloth takes more than {} GiB ({} of its yarn cells are different): "
                        "expected a lower resolution, fewer different yarns, a smaller repeat or no crowding",
                        kMaxBytes >> 30, all));
      task.report(static_cast<double>(++finished) / static_cast<double>(all));
    }
  });
  if (task.stopped()) return false;
  for (size_t i = 0; i < bricks.size(); ++i) bricks[i].tiles->place(bricks[i].kind, made[i]);
  return true;
}

template <class Visit>
void ClothVolume::forEachBrick(const Visit& visit) const {
  for (const TileMap& tiles : tiles_)
    tiles.forEachKind([&](TileMap::Kind kind) {
      if (const auto brick = tiles.brick(kind)) visit((*pool_)[brick], tiles.cells(kind));
    });
}

size_t ClothVolume::brickBytes() const {
  size_t bytes = 0;
  forEachBrick([&](const BrickPool::Entry& brick, double) { bytes += brick.bytes(); });
  return bytes;
}

VolumeCounts ClothVolume::counts() const {
  VolumeCounts counts;
  forEachBrick([&](const BrickPool::Entry& brick, double cells) {
    ++counts.bricks;
    counts.voxels += brick.voxels;
    counts.components += brick.components;
    counts.segments += brick.segments;
    counts.segmentsRepresented += cells * static_cast<double>(brick.segments);
  });
  counts.bytes = sizeof(ClothVolume) + brickBytes();
  for (const TileMap& tiles : tiles_) counts.bytes += tiles.bytes();
  return counts;
}

size_t ClothVolume::bytesBeside(const ClothVolume& other) const {
  size_t bytes = sizeof(ClothVolume);
  for (size_t i = 0; i < tiles_.size(); ++i) bytes += tiles_[i].bytesBeside(other.tiles_[i]);
  return bytes;
}

glm::vec3 ClothVolume::upper_mm() const {
  const glm::dvec3 upper = cell_mm_ * glm::dvec3(cells_);
  return {upper.x, upper.y, -grid_.zLower_mm};
}

BrickView ClothVolume::brick(System system, int pick, int end) const {
  const bool warp = system == System::warp;
  return pool_->view(tiles_[static_cast<int>(system)].brickAt(warp ? end : pick, warp ? pick : end));
}

void ClothVolume::contentAt(glm::vec3 point, VoxelContent& content) const {
  content.count = 0;
  const glm::dvec3 p(point.x, point.y, static_cast<double>(point.z) - grid_.zLower_mm);
  glm::ivec3 cell, voxel;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(p[axis] >= 0 && p[axis] < cell_mm_[axis] * cells_[axis])) return;
    cell[axis] = std::min(static_cast<int>(p[axis] / cell_mm_[axis]), cells_[axis] - 1);
    const double leaf = (p[axis] - cell[axis] * cell_mm_[axis]) / voxel_mm_[axis];
    voxel[axis] = std::clamp(static_cast<int>(leaf), 0, grid_.cell[axis] - 1) >> grid_.level;
  }
  content.end = cell.x;
  content.pick = cell.y;
  content.voxel = cell * grid_.perCell() + voxel;
  Reaches reaches;
  gather(cell.y, cell.x, reaches);
  if (openBlock(reaches, voxel >> 2) != 0) look(reaches, numberInBlock(voxel), content);
}

}  // namespace loomlight
