#pragma once

#include <array>

#include "core/base/simd.h"
#include "core/base/units.h"

namespace loomlight {

/// The surface that a renderer of games, films and garments knows, as glTF 2.0 defines it with its extensions
/// KHR_materials_specular, _anisotropy, _sheen and _diffuse_transmission, without metal:
///
///   f = S (D V F + (1 - F) reflected / pi) + C Dc Vc,  and through it  f = S transmitted / pi
///
/// - D: GGX (Trowbridge-Reitz) with slopes ax along the drawn-out axis and ay across; ay = roughness^2 and
///   ax = mix(ay, 1, anisotropy^2); V: its masking and shadowing after Smith, correlated by height;
/// - F: Schlick's, from 0.04 specular at the normal to `specular` at grazing;
/// - Dc: "Charlie" (Estevez and Kulla 2017) with the roughness sheenRoughness^2; Vc = 1 / (4 (nl + nv - nl nv))
///   (Neubelt and Pettineo 2013); C: the sheen's colour;
/// - S: 1 - max(C) max(E(nl), E(nv)), what the sheen leaves to the rest, where E is its albedo.
struct Principled {
  float specular = 1;           ///< 0..1
  float roughness = 1;          ///< 0.05..1
  float anisotropy = 0;         ///< 0..1
  Rgb sheenColour{0};           ///< linear, 0..1
  float sheenRoughness = 0.5f;  ///< 0.1..1
};

/// A point of such a surface. Directions are in the picture's frame: x right, y up, z towards the eye.
struct PrincipledPoint {
  glm::vec3 normal{0, 0, 1};
  glm::vec2 drawnOut{1, 0};          ///< in the plane of the picture: the axis along which highlights are long; unit
  float anisotropyScale = 1;         ///< on Principled::anisotropy, 0..1
  float roughnessScale = 1;          ///< on Principled::roughness
  Rgb reflected{0}, transmitted{0};  ///< of the diffuse parts, linear
};

/// The gloss of a point, as it is fitted and as maps have it.
struct PointGloss {
  float roughness = 1;   ///< 0.05..1
  float anisotropy = 0;  ///< 0..1
};
PointGloss glossAt(const Principled& surface, const PrincipledPoint& at);

/// A normal whose slopes are `strength` times as steep, 0..1.
glm::vec3 flattened(glm::vec3 normal, float strength);

/// Albedo of the sheen of colour 1 in light from (or a view into) a direction, over its cosine with the normal: one
/// roughness, made once for many evaluations.
class SheenAlbedo {
 public:
  explicit SheenAlbedo(float sheenRoughness);
  /// Of one direction, or of several side by side.
  template <class T>
  T operator()(T cosine) const {
    const T place = static_cast<float>(kSteps) * least(most(cosine, T{}), broadcast<T>(1));
    const WholeOf<T> below = truncated(least(place, broadcast<T>(kSteps - 1)));
    const T from = gathered(values_.data(), below), to = gathered(values_.data() + 1, below);
    return from + (place - toFloats<T>(below)) * (to - from);
  }

 private:
  static constexpr int kSteps = 16;
  std::array<float, kSteps + 1> values_;
};

/// Slopes of the GGX along the drawn-out axis (x) and across it (y).
glm::vec2 ggxSlopes(const PointGloss& gloss);

/// What is seen of a surface, in two parts: gloss with sheen, and what its diffuse colour is multiplied by; 1/sr, or
/// shares of an even light.
struct LightParts {
  Rgb gloss{0};
  float diffuse = 0;
};

/// A point of a surface, with all that does not depend on where light comes from: made once for many directions, which
/// are unit vectors that point away from it. Directions are asked for one by one or eight side by side (T), by the same
/// formulas; eight take about as long as one.
class LitPoint {
 public:
  /// `sheen`: of the surface's roughness; it must live as long.
  LitPoint(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at);

  /// What light from `in` sends to `out`, by channel: f times the cosine of `in` with the normal, 1/sr. Light from
  /// behind, in.z < 0, is transmitted, other light reflected. 0 where `in` or `out` lies on the wrong side of the
  /// tangent plane of the shading normal, though it is on its right side of the picture.
  template <class T>
  Vec3Of<T> sent(const Vec3Of<T>& in, const Vec3Of<T>& out) const;
  Rgb sent(glm::vec3 in, glm::vec3 out) const;
  /// What is seen from `out` while this side's half of the sky is white: a share of that light, 0..1.
  LightParts evenlyReflected(glm::vec3 out) const;
  /// The same of the other half: what the colour of transmitted light is multiplied by.
  float evenlyTransmitted(glm::vec3 out) const;

 private:
  /// Parts of f times the cosine of `in`: gloss, what the sheen's colour is multiplied by, and the diffuse colour.
  template <class T>
  struct Lobes {
    T gloss{}, sheen{}, diffuse{};
  };
  template <class T>
  Lobes<T> scattered(const Vec3Of<T>& in, const Vec3Of<T>& out) const;
  template <class T>
  T leftBySheen(T cosineIn, T cosineOut) const;
  template <class T>
  Vec3Of<T> inFrame(const Vec3Of<T>& v) const;
  template <class T>
  T heightInPicture(const Vec3Of<T>& v) const;

  Principled surface_;
  const SheenAlbedo& sheen_;
  PrincipledPoint at_;
  float mostSheen_;           ///< of the three channels of its colour
  glm::vec3 along_, across_;  ///< the axis of the highlight, and that across; at right angles to the normal and unit
  glm::vec2 alpha_;           ///< GGX's slopes along them
};

}  // namespace loomlight
