#pragma once

#include "render/trace/medium.h"

namespace loomlight {

/// The cloth as a statistical volume that knows what fibres are: our default. On top of VolumeMedium it has
///
/// finite radius: light meets the surface of a fibre, not its axis. At every step the volume is looked up at p + r w_t
/// +
///   (pi / 2) r (w.d) d, with w uniform on the unit hemisphere about d and w_t its part across d. The component of w_t
///   across any fibre is uniform in [-1, 1], so it is the h of an event in that step, and the mean shift along d is
///   that from the surface to the axis.
/// packing: fibres that do not overlap leave gaps with a mean free path of (1 - phi) / sigma; in exchange light crosses
///   the fibre it is in, from entry to exit. One without the other is far wrong. Only for FibreLayout::packed: fibres
///   laid at random (the report's) overlap, so that gaps are Poisson and light sets out from where it came in.
/// hot spot: the way light came is free of fibres, so a fibre that would block both that way and the new one is not
///   there: extinction at distance s is reduced by max(0, 1 - delta / 2r), delta the distance between both ways seen
///   along the fibre. With the light behind the eye nothing is in shadow. What ends the way, the fibre before, is there
///   for certain, and is met as an explicit cylinder.
///
/// All of it is one law of free flight, for paths and for shadow rays alike, so a white furnace stays exactly white.
class LoomlightMedium final : public Medium {
 public:
  /// Each can be switched off, to see what it does.
  struct Ingredients {
    bool finiteRadius = true;
    bool packing = true;
    bool hotSpot = true;
  };

  /// The scene must outlive the medium.
  explicit LoomlightMedium(const Scene& scene, Ingredients ingredients);
  explicit LoomlightMedium(const Scene& scene) : LoomlightMedium(scene, Ingredients{}) {}

  std::optional<Collision> collide(const Departure& from, glm::vec3 direction, Random& random,
                                   TraceCounts& counts) const override;
  float transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                      TraceCounts& counts) const override;
  Departure leave(const Collision& collision, glm::vec3 wi, int order) const override;

 private:
  /// Steps along the ray; see the .cpp.
  template <class OnStep>
  bool advance(const Departure& from, glm::vec3 direction, float tMax, Random& random, TraceCounts& counts,
               OnStep&& onStep) const;

  const Scene& scene_;
  Ingredients ingredients_;
  float shiftRadius_mm_ = 0;  ///< the mean over the cloth's yarns: look-ups are displaced before it is known whose
  float step_mm_ = 0;
};

}  // namespace loomlight
