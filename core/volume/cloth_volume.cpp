#include "core/volume/cloth_volume.h"

#include <fmt/format.h>

#include <atomic>
#include <map>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace loomlight {

ClothVolume::ClothVolume(std::shared_ptr<const ClothGeometry> geometry, int resolution)
    : geometry_(std::move(geometry)), grid_(makeGrid(*geometry_, resolution)) {
  cells_ = {geometry_->ends(), geometry_->picks(), 1};
  cell_mm_ = {geometry_->warpPitch_mm(), geometry_->weftPitch_mm(), -2.0 * grid_.zLower_mm};
  voxel_mm_ = cell_mm_ / glm::dvec3(grid_.cell);
  perCell_ = 1.0 / cell_mm_;
  perVoxel_ = 1.0 / voxel_mm_;
}

std::shared_ptr<const ClothVolume> ClothVolume::build(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                      const Task& task, const ClothVolume* previous) {
  std::shared_ptr<ClothVolume> volume(new ClothVolume(std::move(geometry), resolution));
  for (const System system : {System::warp, System::weft}) {
    volume->tiles_[static_cast<int>(system)] = TileMap(*volume->geometry_, system, task);
    if (task.stopped()) return nullptr;
  }
  if (!volume->makeBricks(previous, task)) return nullptr;
  return volume;
}

ClothVolume::BrickMap ClothVolume::reusable(const ClothVolume& previous) const {
  BrickMap result;
  if (previous.grid_ != grid_) return result;
  // The same yarn may have another class in another fabric.
  using Yarn = std::pair<System, int>;
  std::set<Yarn> yarns;
  for (const TileMap& tiles : tiles_)
    for (const TileMap::Need& need : tiles.needs()) yarns.emplace(need.key.system, need.key.yarn);
  std::map<Yarn, std::optional<int>> renamed;
  for (const auto& [oldKey, brick] : previous.bricks_) {
    const auto [entry, isNew] = renamed.try_emplace({oldKey.system, oldKey.yarn});
    if (isNew) {
      const YarnGeometry& old = previous.geometry_->yarn(oldKey.system, oldKey.yarn);
      for (const Yarn& yarn : yarns)
        if (yarn.first == oldKey.system && geometry_->yarn(yarn.first, yarn.second) == old) entry->second = yarn.second;
    }
    if (!entry->second) continue;
    CellKey key = oldKey;
    key.yarn = *entry->second;
    result.emplace(key, brick);
  }
  return result;
}

bool ClothVolume::makeBricks(const ClothVolume* previous, const Task& task) {
  if (previous) bricks_ = reusable(*previous);
  BrickMap needed;
  std::vector<CellKey> missing;
  size_t kept = 0;
  for (const TileMap& tiles : tiles_) {
    for (const TileMap::Need& need : tiles.needs()) {
      const auto [entry, isNew] = needed.try_emplace(need.key);
      const auto old = bricks_.find(need.key);
      if (old != bricks_.end()) {
        entry->second = old->second;
        kept += old->second->bytes();
      } else if (isNew) {
        missing.push_back(need.key);
      }
    }
  }

  std::vector<std::shared_ptr<const Brick>> made(missing.size());
  std::atomic<size_t> bytes{kept}, done{0};
  std::atomic<size_t> next{0};
  const size_t workers = std::min<size_t>(missing.size(), task.threads > 0 ? task.threads : hardwareThreads());
  parallelFor(workers, task.threads, [&](size_t) {
    Voxeliser voxelise(grid_);
    for (size_t i = next++; i < missing.size() && !task.stopped(); i = next++) {
      made[i] = std::make_shared<const Brick>(voxelise(geometry_->strands(missing[i]), missing[i].system));
      if ((bytes += made[i]->bytes()) > kMaxBytes)
        throw InputError(
            fmt::format("the volume of this cloth takes more than {} GiB ({} different yarn cells): expected "
                        "a lower resolution, fewer different yarns or a smaller repeat",
                        kMaxBytes >> 30, needed.size()));
      task.report(static_cast<double>(++done) / static_cast<double>(missing.size()));
    }
  });
  if (task.stopped()) return false;

  for (size_t i = 0; i < missing.size(); ++i) needed[missing[i]] = std::move(made[i]);
  bricks_ = std::move(needed);
  for (TileMap& tiles : tiles_)
    for (const TileMap::Need& need : tiles.needs()) tiles.place(need.slot, *bricks_[need.key]);
  return true;
}

VolumeCounts ClothVolume::counts() const {
  VolumeCounts counts;
  counts.bricks = bricks_.size();
  counts.bytes = sizeof(ClothVolume) + bricks_.bucket_count() * sizeof(void*);
  for (const auto& [key, brick] : bricks_) {
    counts.voxels += brick->voxels();
    counts.components += brick->components();
    counts.segments += brick->segments();
    counts.bytes += brick->bytes() + sizeof(CellKey) + sizeof(brick) + 2 * sizeof(void*);
  }
  for (const TileMap& tiles : tiles_) {
    counts.bytes += tiles.bytes();
    for (const TileMap::Need& need : tiles.needs())
      counts.segmentsRepresented += need.cells * static_cast<double>(bricks_.at(need.key)->segments());
  }
  return counts;
}

glm::vec3 ClothVolume::upper_mm() const {
  const glm::dvec3 upper = cell_mm_ * glm::dvec3(cells_);
  return {upper.x, upper.y, -grid_.zLower_mm};
}

const Brick& ClothVolume::brick(System system, int pick, int end) const {
  const bool warp = system == System::warp;
  const TileMap& tiles = tiles_[static_cast<int>(system)];
  const int along = warp ? pick : end;
  return *tiles.at(warp ? end : pick, along, along % tiles.repeatAlong()).brick;
}

void ClothVolume::contentAt(glm::vec3 point, VoxelContent& content, int level) const {
  content.count = 0;
  const glm::dvec3 p(point.x, point.y, static_cast<double>(point.z) - grid_.zLower_mm);
  glm::ivec3 cell, voxel;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(p[axis] >= 0 && p[axis] < cell_mm_[axis] * cells_[axis])) return;
    cell[axis] = std::min(static_cast<int>(p[axis] / cell_mm_[axis]), cells_[axis] - 1);
    const double leaf = (p[axis] - cell[axis] * cell_mm_[axis]) / voxel_mm_[axis];
    voxel[axis] = std::clamp(static_cast<int>(leaf), 0, grid_.cell[axis] - 1) >> level;
  }
  content.end = cell.x;
  content.pick = cell.y;
  content.voxel = cell * grid_.cellAt(level) + voxel;
  Reaches reaches;
  gather(cell.y, cell.x, level, reaches);
  if (openBlock(reaches, voxel >> 2) != 0) look(reaches, numberInBlock(voxel), content);
}

}  // namespace loomlight
