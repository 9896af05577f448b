#include "core/fabric/model/impact.h"

#include <algorithm>
#include <functional>

#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

/// What the fibres of a yarn look like as geometry: the yarn, and of its fibre what is not optics. Values that the yarn
/// does not use are set to one and the same, so that editing them changes nothing.
struct Shape {
  Yarn yarn;
  double radius_um = 0;
  double density_g_cm3 = 0;
  bool operator==(const Shape&) const = default;
};

Shape shapeOf(const Fabric& fabric, int index) {
  const Yarn none;
  Shape shape{fabric.yarns[index], 0, 0};
  Yarn& yarn = shape.yarn;
  const Fibre fibre = meanFibre(yarn, fabric.fibres);
  shape.radius_um = fibre.radius_um;
  yarn.name.clear();
  yarn.fibre = none.fibre;
  yarn.blendFibre = none.blendFibre;
  yarn.blendShare = none.blendShare;
  if (yarn.fibresPerPly) {
    yarn.count_tex = none.count_tex;
  } else {
    shape.density_g_cm3 = fibre.density_g_cm3;  // the number of fibres follows from their mass
  }
  if (yarn.plies == 1) {
    yarn.yarnTwist_per_m = 0;
    yarn.yarnTwistDirection = none.yarnTwistDirection;
  }
  if (yarn.cords == 1) {
    yarn.cableTwist_per_m = 0;
    yarn.cableTwistDirection = none.cableTwistDirection;
  }
  if (yarn.plyTwist_per_m == 0) yarn.plyTwistDirection = none.plyTwistDirection;
  if (yarn.yarnTwist_per_m == 0) yarn.yarnTwistDirection = none.yarnTwistDirection;
  if (yarn.cableTwist_per_m == 0) yarn.cableTwistDirection = none.cableTwistDirection;
  if (yarn.hairiness_per_mm == 0) yarn.hairLength_mm = none.hairLength_mm;
  return shape;
}

/// The fibre without what is geometry or a label: what its light scattering depends on.
Fibre opticsOf(Fibre fibre) {
  const Fibre none;
  fibre.name = none.name;
  fibre.density_g_cm3 = none.density_g_cm3;
  return fibre;
}

/// Whether equal(a[i], b[i]) for all i, both repeating for ever. Two periodic words that agree on a stretch as long as
/// both periods together agree everywhere (Fine and Wilf 1965).
template <class Equal>
bool agreeForEver(const std::vector<int>& a, const std::vector<int>& b, Equal&& equal) {
  for (size_t i = 0; i < a.size() + b.size(); ++i)
    if (!equal(a[i % a.size()], b[i % b.size()])) return false;
  return true;
}

bool sameOptics(const Fabric& before, const Fabric& after) {
  return std::equal(before.fibres.begin(), before.fibres.end(), after.fibres.begin(), after.fibres.end(),
                    [](const Fibre& a, const Fibre& b) { return opticsOf(a) == opticsOf(b); }) &&
         std::equal(before.yarns.begin(), before.yarns.end(), after.yarns.begin(), after.yarns.end(),
                    [](const Yarn& a, const Yarn& b) {
                      return a.fibre == b.fibre && a.blendFibre == b.blendFibre &&
                             (!a.blendFibre || a.blendShare.value_or(0.5) == b.blendShare.value_or(0.5));
                    });
}

/// The headlight shines from where the camera stands, which its field of view does not move.
bool sameEye(const Camera& a, const Camera& b) {
  return a.target_mm == b.target_mm && a.azimuth_deg == b.azimuth_deg && a.elevation_deg == b.elevation_deg &&
         a.distance_mm == b.distance_mm;
}

bool samePicture(RenderSettings a, const RenderSettings& b) {
  a.samplesPerPixel = b.samplesPerPixel;  // more samples of the same picture
  return a == b;
}

bool changesAllBricks(const Fabric& before, const Fabric& after) {
  return before.ends_per_cm != after.ends_per_cm || before.picks_per_cm != after.picks_per_cm ||
         before.render.resolution != after.render.resolution;
}

/// Threads and shapes: `crossings`, `threads` and `reshapedYarns`.
void compareThreads(const Fabric& before, const Fabric& after, Impact& impact) {
  std::vector<Shape> shapesBefore, shapesAfter;
  for (size_t i = 0; i < before.yarns.size(); ++i) shapesBefore.push_back(shapeOf(before, static_cast<int>(i)));
  for (size_t i = 0; i < after.yarns.size(); ++i) shapesAfter.push_back(shapeOf(after, static_cast<int>(i)));
  std::vector<bool> reshaped(after.yarns.size(), false);

  const auto compare = [&](const std::vector<int>& sequenceBefore, const std::vector<int>& sequenceAfter) {
    impact.threads |= !agreeForEver(sequenceBefore, sequenceAfter, std::equal_to<int>());
    agreeForEver(sequenceBefore, sequenceAfter, [&](int a, int b) {
      if (!(shapesBefore[a] == shapesAfter[b])) {
        // The same yarn with other fibres, or a thread that took another yarn's place.
        if (a == b) {
          reshaped[b] = true;
        } else {
          impact.crossings = true;
        }
      }
      return true;
    });
  };
  compare(before.warpSequence, after.warpSequence);
  compare(before.weftSequence, after.weftSequence);
  for (size_t i = 0; i < reshaped.size(); ++i)
    if (reshaped[i]) impact.reshapedYarns.push_back(static_cast<int>(i));
}

}  // namespace

Impact impact(const Fabric& before, const Fabric& after) {
  Impact impact;
  impact.allBricks = changesAllBricks(before, after);
  impact.crossings = !(before.weave == after.weave);
  compareThreads(before, after, impact);
  impact.drape = !(before.drape == after.drape);
  impact.materials = !sameOptics(before, after);
  impact.lighting = !(before.light == after.light) ||
                    (after.light.kind == LightKind::headlight && !sameEye(before.camera, after.camera));
  impact.film = impact.volume() || impact.threads || impact.drape || impact.materials || impact.lighting ||
                !(before.camera == after.camera) || !samePicture(before.render, after.render);
  return impact;
}

bool sameCloth(const Fabric& before, const Fabric& after) {
  if (changesAllBricks(before, after) || !(before.drape == after.drape) || !(before.weave == after.weave)) return false;
  Impact change;
  compareThreads(before, after, change);
  return !change.cloth();
}

}  // namespace loomlight
