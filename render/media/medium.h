#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/base/random.h"
#include "render/scene/camera_rays.h"
#include "render/scene/trace_data.h"

namespace loomlight {

/// A point of the scene, and the shell's tetrahedron it lies in; -1 outside of the shell.
struct ScenePoint {
  glm::vec3 world{0};
  int tet = -1;
};

/// What a path or a pass cost.
struct TraceCounts {
  uint64_t paths = 0;
  uint64_t events = 0;  ///< scattering events
  uint64_t rays = 0;    ///< flights and shadow rays
  uint64_t steps = 0;   ///< voxels with content that they crossed; volume only
  TraceCounts& operator+=(const TraceCounts& other);
};

/// The yarn that a fibre is of: an end of the warp, or a pick of the weft.
struct YarnId {
  System system = System::warp;
  int index = 0;  ///< absolute
  bool operator==(const YarnId&) const = default;
};

/// A scattering event: where a ray met a fibre, and which.
struct Collision {
  ScenePoint place;
  float distance_mm = 0;         ///< along the ray, from the start of the flight
  glm::vec3 incoming{0, 0, -1};  ///< direction of the ray
  glm::vec3 tangent{1, 0, 0};
  float offset = 0;           ///< h: where across the fibre, -1..1
  glm::vec3 normal{0, 0, 1};  ///< of the cloth's face; of the fibre's surface where fibres are explicit
  glm::vec3 axis{0};          ///< nearest point of the fibre's axis; media whose fibres have a radius
  YarnOptics optics;          ///< of its yarn
  int material = 0;           ///< of this fibre: that of the yarn, or in a blend one of its two
  YarnId yarnId;              ///< whose fibre it is
  int yarn = 0;               ///< index into Fabric::yarns
  int end = 0, pick = 0;      ///< the crossing cell
  uint64_t fibre = 0;         ///< which; explicit fibres only
};

/// Where the axis of the fibre is, from where its surface is met and at which offset.
inline glm::vec3 axisOf(const Collision& met) {
  const glm::vec3 forward = met.incoming - glm::dot(met.incoming, met.tangent) * met.tangent;
  const glm::vec3 b = glm::cross(met.tangent, met.incoming);
  const glm::vec3 normal = (met.offset * b - std::sqrt(1 - met.offset * met.offset) * forward) / glm::length(b);
  return met.place.world - met.optics.fibreRadius_mm * normal;
}

/// Fills offsets across a fibre at equal distances over -1..1, beginning with `first`: each is uniform if that is.
/// Returns how many.
inline size_t evenOffsets(float first, std::span<float> offsets) {
  const float step = 2.0f / static_cast<float>(offsets.size());
  for (size_t i = 0; i < offsets.size(); ++i) {
    const float offset = first + static_cast<float>(i) * step;
    offsets[i] = offset > 1 ? offset - 2 : offset;
  }
  return offsets.size();
}

/// Which material a fibre of the yarn is of. The fibres of a blend (melange) are mixed evenly, so a volume needs no
/// voxels of its own for it: every fibre that is met is of the second kind with the share that its kind has.
inline int drawMaterial(const YarnOptics& yarn, Random& random) {
  return yarn.blendShare > 0 && random.uniform() < yarn.blendShare ? yarn.blendMaterial : yarn.material;
}

/// One path on its way through a medium, with all that this medium remembers of it. Its flights follow each other:
/// begin(), then collide() and leave() in turn until nothing is met any more. Between leave() and the next collide()
/// any number of shadow rays may be cast from where it stands, and it may leave the same collision again, another way.
class MediumPath {
 public:
  virtual ~MediumPath() = default;

  /// A new path, which sets out from there and knows nothing yet.
  virtual void begin(const ScenePoint& from) = 0;
  /// The first fibre along a ray; nullopt when the ray leaves the scene. `direction` is unit.
  virtual std::optional<Collision> collide(glm::vec3 direction, Random& random, TraceCounts& counts) = 0;
  /// Goes to where light that takes mode `order` (p) out of the fibre just met into direction wi sets out again.
  virtual void leave(const Collision& met, glm::vec3 wi, int order) = 0;
  /// An unbiased estimate of the probability that a ray from here meets no fibre within `distance`.
  virtual float transmittance(glm::vec3 direction, float distance, Random& random, TraceCounts& counts) const = 0;

  /// Where across the fibre just met the ray may as well have met it, as far as nobody could tell: values of
  /// Collision::offset, each as likely as the others, of which `met`'s own is the first. Fills at least one, at most
  /// all of `offsets`, and returns how many. The mean of any function over them has the expectation that it has at the
  /// first alone, and less variance.
  virtual size_t offsetsAcross(const Collision& met, std::span<float> offsets, Random& random) const {
    (void)random;
    offsets[0] = met.offset;
    return 1;
  }

  virtual const ScenePoint& place() const = 0;            ///< where it stands
  virtual std::unique_ptr<MediumPath> clone() const = 0;  ///< to go on two ways from here
};

/// The next flight of one path of a batch.
struct PathRay {
  uint32_t path = 0;
  glm::vec3 direction{0, 0, -1};  ///< unit
  Random* random = nullptr;       ///< the path's own
};

/// A shadow ray from where one path of a batch stands.
struct ShadowRay {
  uint32_t path = 0;
  glm::vec3 direction{0, 0, -1};  ///< unit
  float distance = 0;             ///< mm
  Random* random = nullptr;       ///< the path's own
  float visible = 0;              ///< what comes of it: MediumPath::transmittance()
};

/// Many paths on their way through a medium side by side, each as a MediumPath is: what one medium can do for many rays
/// at once costs less than the same for one after the other. No path knows of the others, whichever are asked together.
class MediumBatch {
 public:
  virtual ~MediumBatch() = default;

  /// `cone`: of the path's first ray, where that is an eye's.
  virtual void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) = 0;
  /// Every flight's first fibre, as MediumPath::collide(); one entry of `met` for each. No path flies twice.
  virtual void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
                       TraceCounts& counts) = 0;
  virtual void leave(uint32_t path, const Collision& met, glm::vec3 wi, int order) = 0;
  /// Sets `visible` of each. No path has two.
  virtual void transmit(std::span<ShadowRay> rays, TraceCounts& counts) = 0;
  virtual size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const = 0;
};

/// The cloth, as light meets it: everything that paths ask of it, and nothing about how it is stored. Immutable, and
/// safe to ask from many threads.
class Medium {
 public:
  virtual ~Medium() = default;

  /// A path through it, for one thread and as many paths after each other as it likes. The medium must outlive it.
  virtual std::unique_ptr<MediumPath> path() const = 0;
  /// The same for so many paths at once, numbered from 0: one after the other, unless the medium knows better.
  virtual std::unique_ptr<MediumBatch> batch(size_t paths) const;

  /// Whether light that comes straight from a lamp to the first fibre of a path is seen by transmittance() alone,
  /// whatever the flight that goes on from there meets: the report's way. False where both are one law.
  virtual bool seesDirectLightApart() const { return false; }
};

}  // namespace loomlight
