#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

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
  uint64_t events = 0;  ///< fibres met, also those at which paths end that are as long as they may be
  uint64_t rays = 0;    ///< flights and shadow rays
  uint64_t steps = 0;   ///< voxels with content that they crossed; volume only

  TraceCounts& operator+=(const TraceCounts& other) {
    paths += other.paths;
    events += other.events;
    rays += other.rays;
    steps += other.steps;
    return *this;
  }
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
  /// Of the fibre as it lies there. Explicit fibres are thicker where their yarn is, as a line cannot become several;
  /// what light is lost inside of them is counted by their yarn's radius, as real fibres only become more.
  float radius_mm = 0;
  int material = 0;       ///< of this fibre: that of the yarn, or in a blend one of its two
  YarnId yarnId;          ///< whose fibre it is
  int yarn = 0;           ///< index into Fabric::yarns
  int end = 0, pick = 0;  ///< the crossing cell
  uint64_t fibre = 0;     ///< which; explicit fibres only
};

/// Where the axis of the fibre is, from where its surface is met and at which offset.
inline glm::vec3 axisOf(const Collision& met) {
  const glm::vec3 forward = met.incoming - glm::dot(met.incoming, met.tangent) * met.tangent;
  const glm::vec3 b = glm::cross(met.tangent, met.incoming);
  const glm::vec3 normal = (met.offset * b - std::sqrt(1 - met.offset * met.offset) * forward) / glm::length(b);
  return met.place.world - met.radius_mm * normal;
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
  float visible = 0;              ///< what comes of it
};

/// Many paths on their way through a medium side by side, numbered from 0, with all that this medium remembers of each:
/// what one medium can do for many rays at once costs less than the same for one after the other. The flights of a path
/// follow each other: begin(), then collide() and leave() in turn until nothing is met any more. Between leave() and
/// the next collide() any number of shadow rays may be cast from where it stands, and it may leave the same collision
/// again, another way. No path knows of the others, whichever are asked together.
class MediumBatch {
 public:
  virtual ~MediumBatch() = default;

  /// A new path, which sets out from there and knows nothing yet. `cone`: of its first ray, where that is an eye's.
  virtual void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) = 0;
  /// The first fibre along every ray, in `met`; nullopt where the ray leaves the scene. No path flies twice.
  virtual void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
                       TraceCounts& counts) = 0;
  /// Goes to where light sets out again that has travelled `length_radii` of the fibre just met within it, and comes
  /// out in direction wi; 0 where it was reflected.
  virtual void leave(uint32_t path, const Collision& met, glm::vec3 wi, float length_radii) = 0;
  /// Sets `visible` of each: an unbiased estimate of the probability that it meets no fibre. No path has two.
  virtual void transmit(std::span<ShadowRay> rays, TraceCounts& counts) = 0;
  /// Where across the fibre just met the ray may as well have met it, as far as nobody could tell: values of
  /// Collision::offset, each as likely as the others, of which `met`'s own is the first. Fills at least one, at most
  /// all of `offsets`, and returns how many. The mean of any function over them has the expectation that it has at the
  /// first alone, and less variance.
  virtual size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const = 0;

  virtual const ScenePoint& place(uint32_t path) const = 0;  ///< where it stands
  virtual void copy(uint32_t path, uint32_t to) = 0;         ///< `to` goes on from there, another way
};

/// The one path of a batch, for those who have no more.
class MediumPath {
 public:
  explicit MediumPath(std::unique_ptr<MediumBatch> batch) : batch_(std::move(batch)) {}

  void begin(const ScenePoint& from) { batch_->begin(0, from, {}); }
  std::optional<Collision> collide(glm::vec3 direction, Random& random, TraceCounts& counts) {
    const PathRay pathRay{0, direction, &random};
    std::optional<Collision> met;
    batch_->collide({&pathRay, 1}, {&met, 1}, counts);
    return met;
  }
  void leave(const Collision& met, glm::vec3 wi, float length_radii) { batch_->leave(0, met, wi, length_radii); }
  float transmittance(glm::vec3 direction, float distance, Random& random, TraceCounts& counts) {
    ShadowRay ray{0, direction, distance, &random};
    batch_->transmit({&ray, 1}, counts);
    return ray.visible;
  }
  size_t offsetsAcross(const Collision& met, std::span<float> offsets, Random& random) const {
    return batch_->offsetsAcross(0, met, offsets, random);
  }
  const ScenePoint& place() const { return batch_->place(0); }

 private:
  std::unique_ptr<MediumBatch> batch_;
};

/// The cloth, as light meets it: everything that paths ask of it, and nothing about how it is stored. Immutable, and
/// safe to ask from many threads.
class Medium {
 public:
  virtual ~Medium() = default;

  /// So many paths through it, for one thread and as many after each other as it likes. The medium must outlive them.
  virtual std::unique_ptr<MediumBatch> batch(size_t paths) const = 0;
  /// A path alone.
  MediumPath path() const { return MediumPath(batch(1)); }

  /// Whether light that comes straight from a lamp to the first fibre of a path is seen by transmit() alone, whatever
  /// the flight that goes on from there meets: the report's way. False where both are one law.
  virtual bool seesDirectLightApart() const { return false; }

  /// The cloth without what only an eye near by sees of it; as long as this one lives.
  virtual const Medium& fromAfar() const { return *this; }
};

}  // namespace loomlight
