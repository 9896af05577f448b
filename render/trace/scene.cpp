#include "render/trace/scene.h"

#include <algorithm>
#include <cmath>

#include "core/fabric/impact.h"
#include "render/trace/shell_entry.h"

namespace loomlight {
namespace {

int crossings(double extent_mm, double pitch_mm) {
  // An extent that is a whole number of pitches up to rounding must not gain a crossing.
  return std::max(1, static_cast<int>(std::ceil(extent_mm / pitch_mm - 1e-4)));
}

struct ShellParts {
  std::shared_ptr<const Shell> shell;
  std::shared_ptr<const ShellEntry> entry;
};

ShellParts makeShell(const Fabric& fabric, const ClothGeometry& geometry, const DrapeMesh* mesh) {
  const double half = geometry.halfThickness_mm();
  auto shell = mesh ? std::make_shared<const Shell>(*mesh, half)
                    : std::make_shared<const Shell>(Shell::flat(geometry.ends() * fabric.warpPitch_mm(),
                                                                geometry.picks() * fabric.weftPitch_mm(), half));
  auto entry = std::make_shared<const ShellEntry>(shell);
  return {std::move(shell), std::move(entry)};
}

std::vector<Material> makeMaterials(const Fabric& fabric, const Scene* previous) {
  std::vector<Material> materials;
  for (size_t i = 0; i < fabric.fibres.size(); ++i) {
    Material material;
    material.absorption_per_mm = fabric.fibres[i].absorption_per_mm;
    const bool known = previous && i < previous->fabric->fibres.size() &&
                       sameOptics(previous->fabric->fibres[i], fabric.fibres[i]);
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
    optics[sequence[i]] = {fabric.yarns[sequence[i]].fibre,
                           static_cast<float>(geometry.yarn(system, key.yarn).fibreRadius_mm)};
  }
  return optics;
}

}  // namespace

std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> fabric, const Task& task, const Scene* previous) {
  Impact change = Impact::everything();
  if (previous) change = impact(*previous->fabric, *fabric);

  auto scene = std::make_shared<Scene>();
  scene->fabric = fabric;

  if (previous && !change.geometry && !change.shell) {
    scene->volume = previous->volume;
    scene->shell = previous->shell;
    scene->entry = previous->entry;
  } else {
    std::optional<DrapeMesh> mesh;
    glm::dvec2 size(fabric->drape.width_mm, fabric->drape.height_mm);
    if (fabric->drape.kind != DrapeKind::flat) {
      mesh = makeDrape(fabric->drape);
      glm::vec2 lower(std::numeric_limits<float>::max()), upper(-std::numeric_limits<float>::max());
      for (const glm::vec2 uv : mesh->uv_mm) {
        lower = glm::min(lower, uv);
        upper = glm::max(upper, uv);
      }
      size = upper - lower;
    }
    auto geometry = std::make_shared<const ClothGeometry>(*fabric, crossings(size.x, fabric->warpPitch_mm()),
                                                          crossings(size.y, fabric->weftPitch_mm()));
    scene->volume = ClothVolume::build(geometry, fabric->render.resolution, task,
                                       previous ? previous->volume.get() : nullptr);
    if (!scene->volume) return nullptr;
    const ShellParts parts = makeShell(*fabric, *geometry, mesh ? &*mesh : nullptr);
    scene->shell = parts.shell;
    scene->entry = parts.entry;
  }
  if (task.stopped()) return nullptr;

  scene->materials = makeMaterials(*fabric, previous);
  scene->yarns = {makeYarnOptics(*fabric, scene->volume->geometry(), System::warp),
                  makeYarnOptics(*fabric, scene->volume->geometry(), System::weft)};
  const bool sameLight = previous && !change.lighting && !(fabric->light.kind == LightKind::headlight && change.camera);
  scene->lighting = sameLight ? previous->lighting
                              : std::make_shared<const Lighting>(fabric->light, CameraRays(fabric->camera, 1, 1).eye_mm());
  return scene;
}

}  // namespace loomlight
