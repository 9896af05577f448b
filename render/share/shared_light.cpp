#include "render/share/shared_light.h"

#include <algorithm>

#include "render/media/close_up_medium.h"
#include "render/scene/camera_rays.h"

namespace loomlight {
namespace {

/// Paths that what a cell knows from before an edit counts for: of a cloth that is the same but for single crossings,
/// and of one that is like it.
constexpr uint32_t kPriorPaths = 16, kPriorPathsOfLike = 4;

constexpr double kRoomOfEarlier = 0.25;  ///< of that for all cells, what those of earlier pictures may take

/// In close-ups of denim voxels of 12 pixels make a clearer picture than the film in its first seconds, and voxels of
/// 50 pixels do not.
constexpr float kWidestVoxel_pixels = 16;

/// Whether voxels of a crossing are counted as before. Where cloth has become a little thicker or thinner, they still
/// lie nearly where they lay.
bool haveLikeVoxels(const Scene& a, const Scene& b) {
  constexpr int kThicker = 2;
  const glm::ivec3 apart = glm::abs(a.cloth->volume->grid().cell - b.cloth->volume->grid().cell);
  return apart.x == 0 && apart.y == 0 && apart.z <= kThicker;
}

/// Of a pixel as far away as the camera's target.
float pixelSize_mm(const Scene& scene, int width, int height) {
  const Camera& camera = scene.fabric->camera;
  return CameraRays(camera, width, height).pixelSize_mm(static_cast<float>(camera.distance_mm));
}

/// Whether media of both meet the same fibres first.
bool sameEvents(const TraceData& a, const TraceData& b) {
  return a.method == b.method && a.estimator == b.estimator && a.eventLaw == b.eventLaw;
}

}  // namespace

SharedFate sharedFate(const Changes& edit) {
  using Cells = SharedFate::Cells;
  const Stages stages = edit.stages;
  if (stages.within(Stage::label)) return {Cells::live, true};
  if (stages.within(Stage::label | Stage::camera)) return {Cells::prior, false};
  // Keys know crossings and the threads around; those further away matter little.
  if (edit.crossingsAlone()) return {Cells::prior, false};
  // They know yarns, materials and how the cloth lies, too. Where other fibres lie in a cell now its light of before is
  // nearer the truth than none.
  if (stages.within(Stage::label | Stage::camera | Stage::shape | Stage::grid | Stage::thread | Stage::drape))
    return {Cells::likely, false};
  if (stages.within(Stage::label | Stage::light | Stage::surroundings | Stage::brightness | Stage::colour |
                    Stage::optics))
    return {Cells::places, true};
  return {Cells::none, false};
}

bool SharedLight::serves(const Scene& scene, int width, int height) {
  if (scene.cloth->method != Method::volume) return false;
  return scene.cloth->volume->grid().size_mm.x <= kWidestVoxel_pixels * pixelSize_mm(scene, width, height);
}

SharedLight::SharedLight(std::shared_ptr<const Scene> scene, std::shared_ptr<const Medium> medium, int width,
                         int height, size_t cells_bytes)
    : scene_(std::move(scene)),
      medium_(std::move(medium)),
      cells_bytes_(cells_bytes),
      cells_(std::make_unique<CellSums>(cells_bytes)),
      hits_(std::make_unique<FirstHits>(width, height)),
      deposits_(std::make_unique<CellDeposits>(*scene_, *cells_, *hits_)) {}

void SharedLight::moveTo(std::shared_ptr<const Scene> scene, std::shared_ptr<const Medium> medium, int width,
                         int height, const Changes& edit) {
  SharedFate fate = sharedFate(edit);
  // The same fabric may come again with bricks that were still missing.
  const bool sameVolume = scene->cloth->volume == scene_->cloth->volume;
  const bool sameCells =
      sameVolume && sameEvents(*scene_->cloth, *scene->cloth) && sameLightCells(*scene_->fabric, *scene->fabric);
  if (!haveLikeVoxels(*scene_, *scene)) fate = {};
  scene_ = std::move(scene);
  medium_ = std::move(medium);
  if (laid_ != scene_->cloth->fibres) laid_.reset();
  switch (fate.cells) {
    case SharedFate::Cells::live:
      break;
    case SharedFate::Cells::prior:
      cells_->fade(kPriorPaths);
      break;
    case SharedFate::Cells::likely:
      cells_->fade(kPriorPathsOfLike);
      break;
    case SharedFate::Cells::places:
      cells_->fade(0);
      break;
    case SharedFate::Cells::none:
      cells_ = std::make_unique<CellSums>(cells_bytes_);
      break;
  }
  if (!fate.hits || !sameCells || width != hits_->width() || height != hits_->height()) {
    // Most cells of the picture before may never be looked for again, and those of the next need room.
    cells_->keep(static_cast<size_t>(kRoomOfEarlier * static_cast<double>(cells_->roomFor(0))));
    hits_ = std::make_unique<FirstHits>(width, height);
  }
  deposits_ = std::make_unique<CellDeposits>(*scene_, *cells_, *hits_);
}

/// Whether paths of pixels that are so many times as wide as the picture's do.
bool SharedLight::goAmongFibres(float times) const {
  return closeUpChance(*scene_->cloth, times * pixelSize_mm(*scene_, hits_->width(), hits_->height())) > 0;
}

bool SharedLight::waitsForFibres() const {
  constexpr float kCoarse = 2;  // or more
  return goAmongFibres(1) && !goAmongFibres(kCoarse) && scene_->cloth->fibres != laid_;
}

void SharedLight::wholeSampleTraced() {
  if (goAmongFibres(1)) laid_ = scene_->cloth->fibres;
}

uint32_t SharedLight::samplesAtOnce(int width, int height) {
  // Each takes 20 bytes in a list that doubles as it grows, and 40 where its cell is new.
  constexpr double kPaths = 4e6;
  return static_cast<uint32_t>(std::max(1.0, kPaths / std::max(1.0, static_cast<double>(width) * height)));
}

FirstFibreSink* SharedLight::listener(uint32_t samples, int divider) {
  deposits_->ofPixels(divider == 1);
  return samples < kEnough ? deposits_.get() : nullptr;
}

bool SharedLight::addHits(uint32_t perPixel, const Task& task, double budget_s) {
  // Cells are voxels, so that single fibres would tell nothing more; and to lay them takes seconds.
  return hits_->trace(perPixel, *scene_, medium_->fromAfar(), *cells_, task, budget_s);
}

std::optional<KnownView> SharedLight::known(const CoarseFilm& coarse, int finer, const Task& task) const {
  const CameraRays camera(scene_->fabric->camera, hits_->width(), hits_->height(), coarse.divider / finer);
  const int width = finer * coarse.film.width(), height = finer * coarse.film.height();
  auto view = knownView(*scene_, medium_->fromAfar(), *cells_, camera, width, height, task);
  if (view) brightenTo(view->picture, coarse.film, finer, task.threads);
  return view;
}

std::vector<glm::vec4> SharedLight::picture(const Film& film, std::span<const CoarseFilm> coarser, int threads) const {
  return corrected(sharedPicture(*hits_, CellMeans(*cells_), threads), film, coarser, kFilmAlone, threads);
}

}  // namespace loomlight
