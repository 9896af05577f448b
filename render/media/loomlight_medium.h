#pragma once

#include <array>
#include <memory>
#include <span>

#include "render/media/lane_walker.h"

namespace loomlight {

/// The cloth as a statistical volume that knows what fibres are: our default. It begins as the volume of the report
/// (section 8.1): virtual scattering events, whose free flights are exact exponentials through the summed extinction of
/// every voxel; the component that is met is chosen in proportion to its own extinction, its tangent weighted by the
/// sine, which is the law of the fibre that a random ray hits (EventLaw::projected); or the component by density alone
/// and the tangent not weighted (EventLaw::report). Where across the fibre is uniform, and a fibre is a point: light
/// leaves where it came in. On top of that it has
///
/// finite radius: light meets the surface of a fibre, not its axis. Along a ray the one lies before the other by half
///   the mean chord, c = phi / (2 sigma), phi being the share of space that is fibre; so the extinction at p is that of
///   the axes at p + c d. Where light enters a yarn its fibres have more of their surface outwards: of a meeting at p,
///   the offset h and the axis are drawn together, from two antithetic points w of the unit hemisphere about d, each as
///   likely as there are axes at p + r w_t + 2 c (w.d) d, with w_t its part across d. The component of w_t across any
///   fibre is uniform in [-1, 1], as h is, and 2 c (w.d) is c in the mean.
/// packing: fibres that do not overlap leave gaps with a mean free path of (1 - phi) / sigma, phi at the place of the
///   light itself; in exchange light crosses the fibre it is in, from entry to exit. One without the other is far
///   wrong; together, with the shift above, they keep uniform light uniform (E - A = -d.grad phi: what leaves fibres
///   less what meets them is how the room between them changes). Only for FibreLayout::packed: fibres laid at random
///   (the report's) overlap, so that gaps are Poisson and light sets out from where it came in. Fibres that were packed
///   and stray overlap too: of phi counts what their yarn's separation has left (YarnModel), for gaps among fibres that
///   lie anywhere are Poisson. Light may then set out from inside of another fibre, which it does not meet, among
///   explicit fibres as here.
/// boxes: at the rim of a yarn fibres fill a part of their voxel (VoxelBox), and are met there alone, as much denser.
///   Spread over their voxels they would close the slits between yarns, which is where light comes through dense cloth.
/// hot spot: the ways light came are free of fibres, so a fibre that would block both one of them and the new one is
///   not there: extinction at distance s is reduced by max(0, 1 - delta / 2r), delta the distance between both ways
///   seen along the fibre. With the light behind the eye nothing is in shadow. Two flights are remembered: with one,
///   light of two events is 10-20 % short, since where it turned back the eye's own ray is still near. What ends the
///   last way, the fibre before, is there for certain, and is met as an explicit cylinder, which voxels of packed
///   yarns then do not count again; those of fibres laid at random do, which was measured to be nearer to them.
///
/// All of it is one law of free flight, for paths and for shadow rays alike, so a white furnace stays exactly white.
class LoomlightMedium final : public Medium {
 public:
  /// The first three can be switched off one by one, to see what each does. The others are as here wherever one of the
  /// first three is on.
  struct Ingredients {
    bool finiteRadius = true;
    bool packing = true;
    bool hotSpot = true;
    bool boxes = true;
    EventLaw law = EventLaw::projected;
  };
  /// The volume alone: none of them.
  static constexpr Ingredients plain(EventLaw law) { return {false, false, false, false, law}; }

  LoomlightMedium(std::shared_ptr<const TraceData> cloth, Ingredients ingredients);
  explicit LoomlightMedium(std::shared_ptr<const TraceData> cloth) : LoomlightMedium(std::move(cloth), Ingredients{}) {}

  /// How the last fibre was met: from which two antithetic points of the hemisphere about the ray its axis was chosen
  /// (above), and whether both led to the part of the found voxel in which all of its components are.
  struct HowMet {
    bool amongAll = false;
    glm::vec3 points[2]{};  ///< the one that was taken first; along the axes of FibreFrame about the ray, and along it
    glm::vec3 lower_mm{0}, upper_mm{0};  ///< of where all of them are, from the light, in cloth space
    float ahead_mm = 0;                  ///< c
  };
  /// Of a path.
  struct Memory {
    KnownFibres known;  ///< nothing without the hot spot
    HowMet howMet;
  };

  std::unique_ptr<MediumBatch> batch(size_t paths) const override;

  // What a batch is made of:
  const TraceData& cloth() const { return *cloth_; }
  const Ingredients& ingredients() const { return ingredients_; }
  WalkRules walkRules() const {
    return {farthest_mm_, ingredients_.packing, ingredients_.hotSpot, ingredients_.boxes,
            ingredients_.law == EventLaw::report};
  }
  float radius_mm() const { return radius_mm_; }  ///< see below
  glm::mat3 toClothOf(int tet) const;             ///< d cloth / d world
  /// With the fibre before, as the cylinder that it is.
  Collision meetBefore(const ScenePoint& place, glm::vec3 direction, float distance_mm, Memory& memory) const;
  /// Keeps a meeting in mind.
  void remember(const Collision& met, Memory& memory) const;
  glm::vec3 exit(const Collision& met, glm::vec3 wi, float length_radii) const;
  size_t offsetsAcross(const Collision& met, const Memory& memory, std::span<float> offsets, Random& random) const;

 private:
  std::shared_ptr<const TraceData> cloth_;
  Ingredients ingredients_;
  float radius_mm_ = 0;    ///< of fibres, the mean over the cloth's yarns: points are drawn before it is known whose
  float farthest_mm_ = 0;  ///< no axis is looked for farther ahead
};

}  // namespace loomlight
