#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/random.h"
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
struct Thread {
  System system = System::warp;
  int index = 0;  ///< absolute
  bool operator==(const Thread&) const = default;
};

/// A fibre that light has met: nearby, a straight cylinder.
struct MetFibre {
  glm::vec3 axis{0};
  glm::vec3 tangent{1, 0, 0};
  float radius_mm = 0;  ///< 0: none
  Thread thread;
  int yarn = 0, end = 0, pick = 0;
};

/// A flight that ended at a collision: a way now known to be free of fibres.
struct Flight {
  glm::vec3 end{0};
  glm::vec3 direction{0, 0, -1};
  float length_mm = 0;  ///< 0: none
};

/// A scattering event: where a ray met a fibre, and which.
struct Collision {
  ScenePoint place;
  float distance_mm = 0;         ///< along the ray, from the start of the flight
  glm::vec3 incoming{0, 0, -1};  ///< direction of the ray
  glm::vec3 tangent{1, 0, 0};
  float offset = 0;           ///< h: where across the fibre, -1..1
  glm::vec3 normal{0, 0, 1};  ///< of the cloth's face; of the fibre's surface where fibres are explicit
  YarnOptics optics;
  Thread thread;          ///< whose fibre it is; media that remember it
  int yarn = 0;           ///< index into Fabric::yarns
  int end = 0, pick = 0;  ///< the crossing cell
  int events = 1;         ///< fibres met on the path so far, this one included
  glm::vec3 axis{0};      ///< nearest point of the fibre's axis; media whose fibres have a radius
  MetFibre before;        ///< the fibre that the flight came from; media that remember it
  Flight earlier;         ///< the flight to that fibre; media that remember it
  uint64_t fibre = 0;     ///< which; explicit fibres only
};

/// Where light sets out: from the eye, or from the fibre that it has just left.
struct Departure {
  ScenePoint place;
  int events = 0;          ///< fibres met on the path so far
  uint64_t fibre = 0;      ///< the fibre it leaves; 0: none, or unknown
  float clearance_mm = 0;  ///< within this distance that fibre is not met again
  /// Media that remember them: the fibre it leaves, the one before, and the flights to both, the newest first.
  MetFibre leaving{}, before{};
  std::array<Flight, 2> flights{};
};

/// The cloth, as light meets it: everything a path asks of it, and nothing about how it is stored. Immutable, and safe
/// to ask from many threads.
class Medium {
 public:
  virtual ~Medium() = default;

  /// The first fibre along a ray; nullopt when the ray leaves the scene. `direction` is unit.
  virtual std::optional<Collision> collide(const Departure& from, glm::vec3 direction, Random& random,
                                           TraceCounts& counts) const = 0;

  /// An unbiased estimate of the probability that a ray meets no fibre within `distance`.
  virtual float transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                              TraceCounts& counts) const = 0;

  /// Whether light that comes straight from a lamp to the first fibre of a path is seen by transmittance() alone,
  /// whatever the flight that goes on from there meets: the report's way. False where both are one law.
  virtual bool seesDirectLightApart() const { return false; }

  /// Where light that takes mode `order` (p) out of the fibre into direction wi sets out again.
  virtual Departure leave(const Collision& collision, glm::vec3 wi, int order) const = 0;
};

}  // namespace loomlight
