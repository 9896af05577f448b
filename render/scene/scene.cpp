#include "render/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/fabric/model/impact.h"
#include "core/fabric/model/yarn_count.h"
#include "render/scene/cells_in_view.h"
#include "render/scene/shell_entry.h"

namespace loomlight {
namespace {

int crossings(double extent_mm, double pitch_mm) {
  // An extent that is a whole number of pitches up to rounding, of a mesh in floats, must not gain a crossing.
  const double count = extent_mm / pitch_mm;
  return std::max(1, static_cast<int>(std::ceil(count - 1e-4 - 1e-6 * count)));
}

/// The cloth that a fabric's drape asks for.
struct Piece {
  std::optional<DrapeMesh> mesh;  ///< none: flat
  int ends = 1, picks = 1;
};

Piece makePiece(const Fabric& fabric) {
  Piece piece;
  glm::dvec2 size_mm(fabric.drape.width_mm, fabric.drape.height_mm);
  if (fabric.drape.kind != DrapeKind::flat) {
    piece.mesh = makeDrape(fabric.drape);
    glm::vec2 lower(std::numeric_limits<float>::max()), upper(-std::numeric_limits<float>::max());
    for (const glm::vec2 uv : piece.mesh->uv_mm) {
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
  if (piece.mesh) return std::make_shared<const Shell>(*piece.mesh, half);
  return std::make_shared<const Shell>(
      Shell::flat(geometry.ends() * geometry.warpPitch_mm(), geometry.picks() * geometry.weftPitch_mm(), half));
}

bool sameOptics(const Fibre& a, const Fibre& b) {
  return a.refractiveIndex == b.refractiveIndex && a.longitudinalRoughness == b.longitudinalRoughness &&
         a.azimuthalRoughness == b.azimuthalRoughness && a.scaleTilt_deg == b.scaleTilt_deg && a.section == b.section;
}

std::vector<Material> makeMaterials(const Fabric& fabric, const Scene* previous) {
  std::vector<Material> materials;
  for (size_t i = 0; i < fabric.fibres.size(); ++i) {
    Material material;
    const bool known =
        previous && i < previous->fabric->fibres.size() && sameOptics(previous->fabric->fibres[i], fabric.fibres[i]);
    material.bcsdf = known ? previous->materials[i].bcsdf : std::make_shared<const FibreBcsdf>(fabric.fibres[i]);
    materials.push_back(std::move(material));
  }
  return materials;
}

/// The radius is the geometry's, which rounds fibre counts; yarns that the cloth does not use have none.
std::vector<YarnOptics> makeYarnOptics(const Fabric& fabric, const ClothGeometry& geometry, System system) {
  std::vector<YarnOptics> optics(fabric.yarns.size());
  const auto& sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
  for (size_t i = 0; i < sequence.size(); ++i) {
    const int index = static_cast<int>(i);
    const CellKey key = system == System::warp ? geometry.key(system, 0, index) : geometry.key(system, index, 0);
    const Yarn& yarn = fabric.yarns[sequence[i]];
    optics[sequence[i]] = {yarn.fibre, yarn.layout == FibreLayout::packed,
                           static_cast<float>(geometry.yarn(system, key.yarn).fibreRadius_mm)};
  }
  return optics;
}

std::vector<YarnBlend> makeBlends(const Fabric& fabric) {
  std::vector<YarnBlend> blends;
  for (const Yarn& yarn : fabric.yarns)
    blends.push_back({yarn.blendFibre.value_or(yarn.fibre), static_cast<float>(blendNumberShare(yarn, fabric.fibres))});
  return blends;
}

/// The cloth and what hangs on it; without its volume so far.
void lay(Scene& scene, const Piece& piece, const ClothGeometry& geometry, const Impact& change, const Scene* previous) {
  const bool sameShell = previous && !change.drape && !change.allBricks &&
                         previous->volume->geometry().halfThickness_mm() == geometry.halfThickness_mm();
  scene.shell = sameShell ? previous->shell : makeShell(piece, geometry);
  scene.entry = sameShell ? previous->entry : std::make_shared<const ShellEntry>(scene.shell);
  scene.yarns = {makeYarnOptics(*scene.fabric, geometry, System::warp),
                 makeYarnOptics(*scene.fabric, geometry, System::weft)};
}

/// Shows the scene with yarns that were made in no time. False when stopped.
bool showSketch(Scene scene, const Piece& piece, std::shared_ptr<const ClothGeometry> sketch, const Impact& change,
                const Scene* previous, const FirstScenes& first, const Task& task) {
  const Fabric& fabric = *scene.fabric;
  lay(scene, piece, *sketch, change, previous);
  const CellRect inView = cellsInView(fabric.camera, first.aspect, *sketch, *scene.shell, *scene.entry);
  scene.volume = ClothVolume::draft(std::move(sketch), fabric.render.resolution, inView, task,
                                    previous ? previous->volume.get() : nullptr);
  if (!scene.volume) return false;
  first.show(std::make_shared<const Scene>(std::move(scene)));
  return !task.stopped();
}

/// Volume, shell and yarns: all of them, or what the edit leaves of the previous scene's. False when stopped.
bool makeCloth(Scene& scene, const Impact& change, const Scene* previous, const FirstScenes* first, const Task& task) {
  const Fabric& fabric = *scene.fabric;
  if (previous && !change.cloth()) {
    scene.volume = previous->volume;
    scene.shell = previous->shell;
    scene.entry = previous->entry;
    scene.yarns = {makeYarnOptics(fabric, scene.volume->geometry(), System::warp),
                   makeYarnOptics(fabric, scene.volume->geometry(), System::weft)};
    return true;
  }
  Stopwatch watch;
  const Piece piece = makePiece(fabric);
  const auto makeGeometry = [&](const ClothGeometry* known, bool sketched) {
    return std::make_shared<const ClothGeometry>(fabric, piece.ends, piece.picks, known, sketched, task);
  };
  auto geometry = makeGeometry(previous ? &previous->volume->geometry() : nullptr, first != nullptr);
  if (task.stopped()) return false;
  if (geometry->isSketched()) {
    if (!showSketch(scene, piece, geometry, change, previous, *first, task)) return false;
    geometry = makeGeometry(geometry.get(), false);  // all but the sketched yarns are as they should be
    if (task.stopped()) return false;
  }
  scene.seconds.geometry = watch.lap();
  lay(scene, piece, *geometry, change, previous);
  scene.seconds.accelerate = watch.lap();
  const auto build = [&](const FirstLook* look) {
    return ClothVolume::build(geometry, fabric.render.resolution, task, previous ? previous->volume.get() : nullptr,
                              look);
  };
  if (first) {
    const FirstLook look{cellsInView(fabric.camera, first->aspect, *geometry, *scene.shell, *scene.entry),
                         first->wanted, [&](std::shared_ptr<const ClothVolume> draft) {
                           auto shown = std::make_shared<Scene>(scene);
                           shown->volume = std::move(draft);
                           first->show(shown);
                         }};
    scene.volume = build(&look);
  } else {
    scene.volume = build(nullptr);
  }
  scene.seconds.voxelise = watch.lap();
  return scene.volume != nullptr;
}

}  // namespace

std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> fabric, const Task& task, const Scene* previous,
                                       const FirstScenes* first) {
  const Impact change = previous ? impact(*previous->fabric, *fabric) : Impact{};
  auto scene = std::make_shared<Scene>();
  scene->fabric = fabric;
  scene->materials = makeMaterials(*fabric, previous);
  for (const Fibre& fibre : fabric->fibres) scene->absorption_per_mm.push_back(fibre.absorption_per_mm);
  scene->roulette_per_mm = scene->absorption_per_mm;
  scene->blends = makeBlends(*fabric);
  // A headlight goes with the eye: that is in `lighting`.
  scene->lighting = previous && !change.lighting
                        ? previous->lighting
                        : std::make_shared<const Lighting>(fabric->light, CameraRays(fabric->camera, 1, 1).eye_mm(),
                                                           static_cast<float>(fabric->camera.distance_mm),
                                                           previous ? previous->lighting.get() : nullptr);
  return makeCloth(*scene, change, previous, first, task) ? scene : nullptr;
}

}  // namespace loomlight
