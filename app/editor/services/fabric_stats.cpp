#include "app/editor/services/fabric_stats.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/fabric/model/changes.h"
#include "core/fabric/model/yarn_count.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/shell/drape_mesh.h"
#include "render/scene/fibre_bricks.h"

namespace loomlight {
namespace {

/// A plain weave of one yarn: what shapes a section is the yarn and its sett; a jacquard's repeat is not needed.
Fabric plainClothOf(const Fabric& fabric, int yarn) {
  Fabric plain;
  plain.yarns = {fabric.yarns[static_cast<size_t>(yarn)]};
  plain.fibres = {meanFibre(plain.yarns[0], fabric.fibres)};
  plain.yarns[0].fibre = 0;
  plain.yarns[0].blendFibre.reset();
  plain.ends_per_cm = fabric.ends_per_cm;
  plain.picks_per_cm = fabric.picks_per_cm;
  plain.press = fabric.press;
  plain.singed = fabric.singed;
  plain.brushed = fabric.brushed;
  plain.milling = fabric.milling;
  plain.crimpBalance = fabric.crimpBalance;
  return plain;
}

/// A cell in which the yarn lies; none where the cloth does not use it.
std::optional<YarnCellKey> cellOf(const ClothGeometry& cloth, const Fabric& fabric, int yarn) {
  for (const System system : {System::warp, System::weft}) {
    const std::vector<int>& sequence = fabric.sequence(system);
    const auto found = std::find(sequence.begin(), sequence.end(), yarn);
    if (found == sequence.end()) continue;
    const auto index = static_cast<int>(found - sequence.begin());
    return system == System::warp ? cloth.key(system, 0, index) : cloth.key(system, index, 0);
  }
  return std::nullopt;
}

/// Of the yarn where it is as thick as on average. `secondShare`: how many of the fibres are the second ones of a
/// blend.
YarnSection sectionIn(const ClothGeometry& cloth, const YarnCellKey& key, double secondShare) {
  const YarnModel& yarn = cloth.yarns().model(key.system, key.yarn);
  const double diameter_mm = yarn.geometry.diameter_mm();
  const CellStrands strands =
      layStrands(yarn, key.previous, key.here, key.next, {key.phase, {}}, yarn.geometry.pitch_mm);
  YarnSection section;
  section.fibreRadius_mm = strands.fibreRadius_mm;
  section.halfWidth_mm = 0.5 * diameter_mm * key.here.across;
  section.halfHeight_mm = 0.5 * diameter_mm * key.here.up;
  for (size_t k = 0; k < strands.strands.size(); ++k) {
    const CellStrands::Strand& strand = strands.strands[k];
    const bool second = Random(k).uniformDouble() < secondShare;  // which ones is chance, as in the yarn
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
      const glm::vec3 a = strands.points[i], b = strands.points[i + 1];  // (u, s, z)
      if ((a.y < 0) == (b.y < 0)) continue;
      const glm::vec3 at = glm::mix(a, b, a.y / (a.y - b.y));
      section.points.push_back(
          {{at.x - key.here.aside_mm, at.z - key.here.height_mm}, strand.ply, strand.loose, second});
    }
  }
  return section;
}

/// Of a mesh that can be read.
std::optional<MeshExtent> extentOf(const Drape& drape) {
  if (!hasOwnExtent(drape)) return std::nullopt;
  try {
    const DrapeMesh mesh = makeDrape(drape);
    if (mesh.positions.empty()) return std::nullopt;
    glm::vec3 lower = mesh.positions.front(), upper = lower;
    for (const glm::vec3& p : mesh.positions) {
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
    return MeshExtent{0.5f * (lower + upper), 0.5 * glm::length(upper - lower)};
  } catch (const InputError&) {
    return std::nullopt;  // the builder reads it too, and tells the user
  }
}

}  // namespace

YarnSection yarnSection(const ClothGeometry& cloth, const Fabric& fabric, int yarn) {
  const double secondShare = blendNumberShare(fabric.yarns[static_cast<size_t>(yarn)], fabric.fibres);
  if (const auto key = cellOf(cloth, fabric, yarn)) return sectionIn(cloth, *key, secondShare);
  const ClothGeometry plain(plainClothOf(fabric, yarn), 2, 2);
  return sectionIn(plain, plain.key(System::warp, 0, 0), secondShare);
}

FabricStatsWorker::FabricStatsWorker(std::function<void()> wake, Compute compute)
    : compute_(std::move(compute)),
      worker_(
          std::move(wake), [this](const Request& request, const auto&) { return tell(request); },
          [this](const Request&, const std::string& problem) { return Result{last_, problem}; }) {}

void FabricStatsWorker::request(std::shared_ptr<const Fabric> fabric, int yarn, std::shared_ptr<const Scene> built,
                                double longFloat_mm) {
  worker_.ask({std::move(fabric), yarn, std::move(built), longFloat_mm});
}

std::shared_ptr<const FabricStats> FabricStatsWorker::newest() const {
  const auto told = worker_.newest();
  return told ? told->stats : nullptr;
}

std::string FabricStatsWorker::problem() const {
  const auto told = worker_.newest();
  return told ? told->problem : "";
}

FabricStats FabricStatsWorker::statsOf(const Fabric& fabric) {
  FabricStats stats;
  stats.floats = floats(fabric.weave);
  stats.binding = binding(fabric.weave);
  return stats;
}

FabricStatsWorker::Result FabricStatsWorker::tell(const Request& request) {
  const int yarn = std::min(request.yarn, static_cast<int>(request.fabric->yarns.size()) - 1);
  const bool known = last_ && last_->fabric == request.fabric;
  auto stats = std::make_shared<FabricStats>(known ? *last_ : compute_(*request.fabric));
  if (!known) {
    stats->fabric = request.fabric;
    const bool sameDrape = last_ && !changes(*last_->fabric, *request.fabric).stages.any(Stage::drape);
    stats->mesh = sameDrape ? last_->mesh : extentOf(request.fabric->drape);
  }
  stats->yarn = yarn;
  if (!known || stats->longFloats.limit_mm != request.longFloat_mm)
    stats->longFloats = longFloats(*request.fabric, request.longFloat_mm);
  stats->warnings = warnings(*request.fabric, stats->floats, stats->longFloats);
  if (request.built)
    for (std::string& remark : request.built->cloth->volume->geometry().spacingRemarks())
      stats->warnings.push_back(std::move(remark));
  if (std::string none = request.built ? FibreBricks::whyNone(request.built->cloth->volume->counts()) : "";
      !none.empty())
    stats->warnings.push_back(std::move(none));
  if (request.built)
    // Its own fabric: the back of a cloth has its ends in the opposite order.
    stats->section = yarnSection(request.built->cloth->volume->geometry(), *request.built->fabric, yarn);
  else if (last_ && last_->yarn == yarn)
    stats->section = last_->section;  // until the cloth is built
  else
    stats->section.reset();
  last_ = std::move(stats);
  return {last_, ""};
}

}  // namespace loomlight
