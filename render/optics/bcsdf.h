#pragma once

#include <array>
#include <span>

#include "core/base/random_lanes.h"
#include "core/fabric/model/fabric.h"
#include "render/optics/azimuthal_lobes.h"
#include "render/optics/longitudinal_lobes.h"

namespace loomlight {

/// What light does at one dielectric fibre: reflection R (p = 0), transmission TT (1), internal reflections TRT (2) and
/// the rest (3 and more). Near-field: the offset h across the fibre is an argument. Absorption-free: what is absorbed
/// depends only on the length travelled inside, which every function here reports, in fibre radii, so that colour can
/// be applied once, at the end of a path.
///
/// Frame: the fibre runs along x; directions point away from the fibre, unit length. wo is where the path came from
/// (towards the eye), wi where it goes (towards the light). The value Q includes the cosine to the fibre's normal plane
/// and integrates to one over wi: it is the phase function after a collision. Longitudinal: d'Eon et al. 2011,
/// symmetrised so that it keeps energy from both sides (longitudinal_lobes.h); azimuthal: Chiang et al. 2016, broadened
/// where the section is not round (azimuthal_lobes.h).
///
/// h is the offset of the ray from the axis over the radius: the sine of the angle, about the axis, from the normal at
/// the point that wo leaves to wo. Unless the fibre itself is traced, draw it uniformly from [-1, 1].
/// Immutable after construction, which takes a few milliseconds; safe from any thread.
class FibreBcsdf {
 public:
  static constexpr int kModes = 4;

  /// A direction that was drawn; T is the number of one ray, or of several side by side.
  template <class T>
  struct SampleOf {
    Vec3Of<T> wi;
    WholeOf<T> order{};  ///< p of the chosen mode, 0, 1, 2, 3, 4, ... the residual has p >= 3
    T length_radii{};    ///< travelled inside the fibre, in radii
    T pdf{};             ///< of wi, all modes together; equals the sum of Q, so the weight of a sample is 1
  };
  struct Sample {
    glm::vec3 wi;
    int order = 0;
    float length_radii = 0;
    float pdf = 0;
  };
  template <class T>
  struct ValueOf {
    std::array<T, kModes> q{};  ///< Q of each mode, [3] all p >= 3 together; absorption-free
    T chord_radii{};            ///< length per internal traverse, in radii: mode p travels p of them
    T internalReflectance{};    ///< f: of the residual, the share with order p is (1-f) f^(p-3)
    T sum() const { return q[0] + q[1] + q[2] + q[3]; }
  };
  using Value = ValueOf<float>;

  /// How the light divides among the modes, and how far a traverse is: what a smooth fibre of this index does.
  struct Modes {
    std::array<float, kModes> share{};  ///< sums to one
    float chord_radii = 0;              ///< as in Value
    float internalReflectance = 0;      ///< as in Value
  };

  /// Uses the index, the roughnesses, the scale tilt and the section; takes them as valid.
  explicit FibreBcsdf(const Fibre& fibre);

  /// h in [-1, 1]. Always succeeds.
  Sample sample(glm::vec3 wo, float h, Random& random) const { return draw(wo, h, random, true); }
  /// The same sample with its pdf left at zero, for half the time: where no light is sampled, nobody asks for it.
  Sample sampleWithoutPdf(glm::vec3 wo, float h, Random& random) const { return draw(wo, h, random, false); }
  Value evaluate(glm::vec3 wo, glm::vec3 wi, float h) const;

  /// The same for several rays side by side, each to the bit what it is alone, in a third of the time for a sample and
  /// a sixth for a value (tests/bench/bcsdf_bench.cpp).
  using Lanes = Float32x8;
  SampleOf<Lanes> sample(const Vec3Of<Lanes>& wo, Lanes h, RandomLanes<Lanes>& random, bool withPdf) const;
  /// Each ray at several offsets: what is along the fibre is the same for all.
  void evaluate(const Vec3Of<Lanes>& wo, const Vec3Of<Lanes>& wi, std::span<const Lanes> offsets,
                std::span<ValueOf<Lanes>> values) const;

  Modes modes(glm::vec3 wo, float h) const;

 private:
  Sample draw(glm::vec3 wo, float h, Random& random, bool withPdf) const;
  template <class T>
  SampleOf<T> drawOf(const Vec3Of<T>& wo, T h, RandomLanes<T>& random, bool withPdf) const;
  template <class T>
  void evaluateAll(const Vec3Of<T>& wo, const Vec3Of<T>& wi, std::span<const T> offsets,
                   std::span<ValueOf<T>> values) const;

  float index_;
  optics::LongitudinalLobes along_;
  optics::AzimuthalLobes about_;
};

}  // namespace loomlight
