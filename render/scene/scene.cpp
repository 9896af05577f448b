#include "render/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/hash.h"
#include "core/base/stopwatch.h"
#include "core/fabric/model/finish.h"
#include "core/fabric/model/yarn_count.h"
#include "core/shell/drape_surface.h"
#include "render/scene/cells_in_view.h"
#include "render/scene/fibre_bricks.h"
#include "render/scene/shell_entry.h"

// How it works. Changes say which parts of the scene before still stand; those are shared, the others made in the order
// in which they need one another: geometry, shell and the look-ups of yarns, voxels. Where yarns take long to make, a
// scene of sketched ones is shown first, and scenes of the first bricks after that.

namespace loomlight {
namespace {

int crossings(double extent_mm, double pitch_mm) {
  // An extent that is a whole number of pitches up to rounding, of a mesh in floats, must not gain a crossing.
  const double count = extent_mm / pitch_mm;
  return std::max(1, static_cast<int>(std::ceil(count - 1e-4 - 1e-6 * count)));
}

/// The cloth that a fabric's drape asks for.
struct Piece {
  std::shared_ptr<const DrapeSurface> surface;  ///< null: flat
  int ends = 1, picks = 1;
};

Piece makePiece(const Fabric& fabric, const SceneBase& base) {
  Piece piece;
  glm::dvec2 size_mm(fabric.drape.width_mm, fabric.drape.height_mm);
  if (fabric.drape.kind != DrapeKind::flat) {
    piece.surface = base.keeps(Stage::drape) ? base.scene->cloth->drape
                                             : std::make_shared<const DrapeSurface>(makeDrape(fabric.drape));
    glm::vec2 lower(std::numeric_limits<float>::max()), upper(-std::numeric_limits<float>::max());
    for (const glm::vec2 uv : piece.surface->mesh.uv_mm) {
      lower = glm::min(lower, uv);
      upper = glm::max(upper, uv);
    }
    size_mm = upper - lower;
  }
  piece.ends = crossings(size_mm.x, fabric.warpPitch_mm());
  piece.picks = crossings(size_mm.y, fabric.weftPitch_mm());
  return piece;
}

std::shared_ptr<const Shell> makeShell(const Piece& piece, const ClothGeometry& geometry) {
  const double half = geometry.halfThickness_mm();
  if (piece.surface) return std::make_shared<const Shell>(*piece.surface, half);
  return std::make_shared<const Shell>(
      Shell::flat(geometry.ends() * geometry.warpPitch_mm(), geometry.picks() * geometry.weftPitch_mm(), half));
}

std::vector<Material> makeMaterials(const Fabric& fabric, const SceneBase& base) {
  const std::vector<int>& changed = base.edit.fibres;
  std::vector<Material> materials;
  for (size_t i = 0; i < fabric.fibres.size(); ++i) {
    const Fibre fibre = withFinishedSurface(fabric.fibres[i], fabric);
    const bool known = base.scene && !std::binary_search(changed.begin(), changed.end(), static_cast<int>(i));
    materials.push_back(
        known ? base.scene->cloth->materials[i]
              : Material{std::make_shared<const FibreBcsdf>(fibre), static_cast<float>(fibre.refractiveIndex)});
  }
  return materials;
}

/// The radius is the geometry's, which rounds fibre counts; yarns that the cloth does not use have none.
std::vector<YarnOptics> makeYarnOptics(const Fabric& fabric, const ClothGeometry& geometry, System system) {
  std::vector<YarnOptics> optics(fabric.yarns.size());
  const auto& sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
  for (size_t i = 0; i < sequence.size(); ++i) {
    const int index = static_cast<int>(i);
    const YarnCellKey key = system == System::warp ? geometry.key(system, 0, index) : geometry.key(system, index, 0);
    const Yarn& yarn = fabric.yarns[sequence[i]];
    const bool packed = yarn.layout == FibreLayout::packed;
    optics[sequence[i]] = {yarn.fibre,
                           packed,
                           static_cast<float>(geometry.yarn(system, key.yarn).fibreRadius_mm),
                           yarn.blendFibre.value_or(yarn.fibre),
                           static_cast<float>(0.01 * yarn.shadeVariation_percent),
                           static_cast<float>(blendNumberShare(yarn, fabric.fibres)),
                           packed ? static_cast<float>(geometry.separation(system, key.yarn)) : 0.0f};
  }
  return optics;
}

/// A scene in the making: its cloth has no volume so far.
struct Unfinished {
  Scene scene;
  TraceData cloth;

  std::shared_ptr<const Scene> with(std::shared_ptr<const ClothVolume> volume) const {
    auto finished = std::make_shared<Scene>(scene);
    TraceData traced = cloth;
    traced.volume = std::move(volume);
    finished->cloth = std::make_shared<const TraceData>(std::move(traced));
    return finished;
  }
  void lookUpYarns(const ClothGeometry& geometry) {
    cloth.yarns = {makeYarnOptics(*scene.fabric, geometry, System::warp),
                   makeYarnOptics(*scene.fabric, geometry, System::weft)};
  }
};

/// The shell and what hangs on it.
void lay(Unfinished& made, const Piece& piece, const ClothGeometry& geometry, const SceneBase& base) {
  TraceData& cloth = made.cloth;
  const bool sameShell = base.keeps(Stage::drape | Stage::grid) &&
                         base.scene->cloth->volume->geometry().halfThickness_mm() == geometry.halfThickness_mm();
  cloth.drape = piece.surface;
  cloth.shell = sameShell ? base.scene->cloth->shell : makeShell(piece, geometry);
  cloth.entry = sameShell ? base.scene->cloth->entry : std::make_shared<const ShellEntry>(cloth.shell);
  made.lookUpYarns(geometry);
}

/// Shows the scene with yarns that were made in no time. False when stopped.
bool showSketch(Unfinished sketched, const Piece& piece, std::shared_ptr<const ClothGeometry> sketch,
                const SceneBase& base, const ScenePreviews& first, const Task& task) {
  const Fabric& fabric = *sketched.scene.fabric;
  lay(sketched, piece, *sketch, base);
  const CellRect inView =
      cellsInView(fabric.camera, first.aspect, *sketch, *sketched.cloth.shell, *sketched.cloth.entry);
  auto volume = ClothVolume::sketch(std::move(sketch), fabric.render.resolution, inView, task,
                                    base.scene ? base.scene->cloth->volume.get() : nullptr);
  if (!volume) return false;
  first.show(sketched.with(std::move(volume)));
  return !task.stopped();
}

/// Volume, shell and yarns: all of them, or what the edit leaves of the previous scene's. False when stopped.
bool makeCloth(Unfinished& made, const SceneBase& base, const ScenePreviews* first, const Task& task) {
  const Fabric& fabric = *made.scene.fabric;
  TraceData& cloth = made.cloth;
  const TraceData* before = base.scene ? base.scene->cloth.get() : nullptr;
  const ClothVolume* volumeBefore = before ? before->volume.get() : nullptr;
  if (before && !base.edit.cloth()) {
    cloth.volume = before->volume;
    cloth.drape = before->drape;
    cloth.shell = before->shell;
    cloth.entry = before->entry;
    cloth.fibres = before->fibres;
    made.lookUpYarns(cloth.volume->geometry());
    return true;
  }
  Stopwatch watch;
  const Piece piece = makePiece(fabric, base);
  const auto makeGeometry = [&](const ClothGeometry* known, bool sketched) {
    return std::make_shared<const ClothGeometry>(fabric, piece.ends, piece.picks, known, sketched, task, base.tiling);
  };
  auto geometry = makeGeometry(volumeBefore ? &volumeBefore->geometry() : nullptr, first != nullptr);
  if (task.stopped()) return false;
  if (geometry->isSketched()) {
    if (!showSketch(made, piece, geometry, base, *first, task)) return false;
    geometry = makeGeometry(geometry.get(), false);  // all but the sketched yarns are as they should be
    if (task.stopped()) return false;
  }
  made.scene.seconds.geometry = watch.lap();
  lay(made, piece, *geometry, base);
  made.scene.seconds.accelerate = watch.lap();
  const auto build = [&](const PreviewSink* look) {
    return ClothVolume::build(geometry, fabric.render.resolution, task, volumeBefore, look);
  };
  if (first) {
    const PreviewSink look{
        cellsInView(fabric.camera, first->aspect, *geometry, *cloth.shell, *cloth.entry), first->wanted,
        [&](std::shared_ptr<const ClothVolume> sketch) { first->show(made.with(std::move(sketch))); }};
    cloth.volume = build(&look);
  } else {
    cloth.volume = build(nullptr);
  }
  made.scene.seconds.voxelise = watch.lap();
  if (!cloth.volume) return false;
  const bool sameYarns = before && before->fibres && volumeBefore->geometry().yarns().sameShapes(geometry->yarns());
  cloth.fibres = sameYarns ? before->fibres : FibreBricks::of(*cloth.volume, std::move(geometry));
  return true;
}

}  // namespace

std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> asked, const Task& task, const SceneBase& base,
                                       const ScenePreviews* first) {
  Unfinished made;
  Scene& scene = made.scene;
  scene.fabric = std::move(asked);
  const Fabric& fabric = *scene.fabric;
  scene.colouring = base.keeps(Stage::colour | Stage::brightness | Stage::light | Stage::optics) ? base.scene->colouring
                                                                                                 : colouringOf(fabric);
  scene.roulette_per_mm = leastAbsorption_per_mm(scene.colouring);
  // Seeds that a user counts up differ in their lowest bits alone, as numbers of pixels do: unmixed, the pixels of one
  // seed would have the random numbers of other pixels of the next.
  scene.sampling.seed = mixBits(fabric.render.seed);
  scene.sampling.maxEvents = static_cast<uint32_t>(fabric.render.maxDepth);
  scene.lighting =
      base.keeps(Stage::light | Stage::brightness)
          ? base.scene->lighting
          : std::make_shared<const Lighting>(fabric.light, CameraRays(fabric.camera, 1, 1).eye_mm(),
                                             static_cast<float>(fabric.camera.distance_mm),
                                             base.keeps(Stage::surroundings) ? base.scene->lighting.get() : nullptr);
  if (base.scene && !base.edit.medium()) {
    scene.cloth = base.scene->cloth;
    return std::make_shared<const Scene>(std::move(scene));
  }
  made.cloth.materials = makeMaterials(fabric, base);
  made.cloth.method = fabric.render.method;
  made.cloth.estimator = fabric.render.estimator;
  made.cloth.eventLaw = fabric.render.eventLaw;
  if (!makeCloth(made, base, first, task)) return nullptr;
  scene.cloth = std::make_shared<const TraceData>(std::move(made.cloth));
  return std::make_shared<const Scene>(std::move(scene));
}

std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> fabric, const Task& task, const Scene* previous,
                                       const ScenePreviews* first) {
  const SceneBase base{previous, previous ? changes(*previous->fabric, *fabric) : Changes{}};
  return makeScene(std::move(fabric), task, base, first);
}

}  // namespace loomlight
