#include "app/export/handover/principled.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

constexpr float kNormalReflectance = 0.04f;  ///< of glass of index 1.5

/// Distribution of the sheen's fibres, by the sine of the half vector with the normal.
float charlie(float alpha, float sine) {
  const float inverse = 1 / alpha;
  return (2 + inverse) * std::pow(sine, inverse) / (2 * kPiF);
}

/// D Vc of a sheen.
float sheenLobe(float alpha, float cosineHalf, float cosineIn, float cosineOut) {
  const float sine = std::sqrt(std::max(0.0f, 1 - cosineHalf * cosineHalf));
  return charlie(alpha, sine) / (4 * (cosineIn + cosineOut - cosineIn * cosineOut));
}

/// A normal with the axis of its highlight and the axis across, all unit and at right angles.
struct Frame {
  glm::vec3 along, across, normal;

  explicit Frame(const PrincipledPoint& at) : normal(at.normal) {
    const glm::vec3 axis(at.drawnOut, 0);
    along = glm::normalize(axis - glm::dot(axis, normal) * normal);
    across = glm::cross(normal, along);
  }
  glm::vec3 of(glm::vec3 v) const { return {glm::dot(v, along), glm::dot(v, across), glm::dot(v, normal)}; }
  glm::vec3 inPicture(glm::vec3 v) const { return v.x * along + v.y * across + v.z * normal; }
};

glm::vec2 slopesOf(const Principled& surface, const PrincipledPoint& at) {
  return ggxSlopes(std::clamp(surface.roughness * at.roughnessScale, 0.05f, 1.0f),
                   surface.anisotropy * at.anisotropyScale);
}

/// D of GGX, of a half vector in the frame of the surface.
float ggx(glm::vec2 alpha, glm::vec3 half) {
  const glm::vec3 stretched(half.x / alpha.x, half.y / alpha.y, half.z);
  const float square = glm::dot(stretched, stretched);
  return 1 / (kPiF * alpha.x * alpha.y * square * square);
}

/// D V of GGX; directions in the frame of the surface, above it.
float glossLobe(glm::vec2 alpha, glm::vec3 in, glm::vec3 out, glm::vec3 half) {
  const auto reach = [&](glm::vec3 v) { return glm::length(glm::vec3(alpha.x * v.x, alpha.y * v.y, v.z)); };
  return ggx(alpha, half) * 0.5f / (in.z * reach(out) + out.z * reach(in));
}

float largest(const Rgb& colour) {
  return std::max({colour.r, colour.g, colour.b});
}

/// Point k of a lattice in the unit square, as a place from 0 to 1 and an azimuth, radians. Points come in pairs that
/// face each other, so that what only tilts between them adds up to nothing.
constexpr int kLattice = 256;
struct LatticePoint {
  float place, azimuth;
};
LatticePoint latticePoint(int k) {
  constexpr float kGolden = 0.6180340f;
  const int pair = k / 2;
  const float turns = 0.5f * (kGolden * static_cast<float>(pair) + static_cast<float>(k % 2));
  return {2 * (static_cast<float>(pair) + 0.5f) / kLattice, 2 * kPiF * (turns - std::floor(turns))};
}

/// Spread as projected solid angle over the half of the sky: as dense as the cosine over pi.
glm::vec3 cosineDirection(const LatticePoint& point) {
  const float sine = std::sqrt(point.place);
  return {sine * std::cos(point.azimuth), sine * std::sin(point.azimuth), std::sqrt(1 - point.place)};
}

/// Spread as GGX's normals are by the area that they cover: as dense as D times the cosine.
glm::vec3 ggxNormal(glm::vec2 alpha, const LatticePoint& point) {
  const float slope = std::sqrt(point.place / (1 - point.place));
  return glm::normalize(
      glm::vec3(alpha.x * slope * std::cos(point.azimuth), alpha.y * slope * std::sin(point.azimuth), 1));
}

float leftBySheen(const Principled& surface, const SheenAlbedo& sheen, float cosineIn, float cosineOut) {
  return 1 - largest(surface.sheenColour) * std::max(sheen(cosineIn), sheen(cosineOut));
}

}  // namespace

glm::vec3 flattened(glm::vec3 normal, float strength) {
  return glm::normalize(glm::vec3(strength * normal.x, strength * normal.y, normal.z));
}

SheenAlbedo::SheenAlbedo(float sheenRoughness) {
  constexpr int kAzimuths = 24, kCosines = 24;
  const float alpha = sheenRoughness * sheenRoughness;
  for (int i = 0; i <= kSteps; ++i) {
    const float cosine = std::max(0.01f, static_cast<float>(i) / kSteps);
    const glm::vec3 in(std::sqrt(1 - cosine * cosine), 0, cosine);
    float sum = 0;
    for (int j = 0; j < kCosines; ++j)
      for (int k = 0; k < kAzimuths; ++k) {
        const float c = (static_cast<float>(j) + 0.5f) / kCosines, s = std::sqrt(1 - c * c);
        const float azimuth = kPiF * (static_cast<float>(k) + 0.5f) / kAzimuths;  // the other half is its mirror image
        const glm::vec3 out(s * std::cos(azimuth), s * std::sin(azimuth), c);
        sum += sheenLobe(alpha, glm::normalize(in + out).z, cosine, c) * c;
      }
    values_[static_cast<size_t>(i)] = std::min(1.0f, sum * 2 * kPiF / (kAzimuths * kCosines));
  }
}

float SheenAlbedo::operator()(float cosine) const {
  const float place = std::clamp(cosine, 0.0f, 1.0f) * kSteps;
  const auto below = std::min(static_cast<size_t>(place), size_t{kSteps - 1});
  return std::lerp(values_[below], values_[below + 1], place - static_cast<float>(below));
}

Rgb reflectedLight(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at, glm::vec3 in,
                   glm::vec3 out) {
  const Frame frame(at);
  const glm::vec3 i = frame.of(in), o = frame.of(out);
  if (i.z <= 0 || o.z <= 0) return Rgb(0);
  const glm::vec3 half = glm::normalize(i + o);
  const float f0 = kNormalReflectance * surface.specular;
  const float fresnel = f0 + (surface.specular - f0) * std::pow(1 - std::min(1.0f, glm::dot(half, o)), 5.0f);
  const float gloss = fresnel * glossLobe(slopesOf(surface, at), i, o, half);
  const Rgb base = Rgb(gloss) + (1 - fresnel) / kPiF * at.reflected;
  const float fuzz = sheenLobe(surface.sheenRoughness * surface.sheenRoughness, half.z, i.z, o.z);
  return i.z * (leftBySheen(surface, sheen, i.z, o.z) * base + fuzz * surface.sheenColour);
}

Rgb transmittedLight(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at, glm::vec3 in,
                     glm::vec3 out) {
  const float cosineIn = -glm::dot(at.normal, in), cosineOut = glm::dot(at.normal, out);
  if (cosineIn <= 0 || cosineOut <= 0) return Rgb(0);
  return cosineIn * leftBySheen(surface, sheen, cosineIn, cosineOut) / kPiF * at.transmitted;
}

glm::vec2 ggxSlopes(float roughness, float anisotropy) {
  const float across = roughness * roughness;
  return {std::lerp(across, 1.0f, anisotropy * anisotropy), across};
}

Rgb evenLightReflected(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at, glm::vec3 out) {
  const Frame frame(at);
  const glm::vec3 o = frame.of(out);
  if (o.z <= 0) return Rgb(0);
  const glm::vec2 alpha = slopesOf(surface, at);
  Rgb sum(0);
  // Looked for in all directions alone, light would be missed in a narrow highlight, and there alone everywhere else:
  // both, each weighted by how dense the two together are (the balance heuristic).
  const auto add = [&](glm::vec3 i) {
    const glm::vec3 in = frame.inPicture(i);
    if (in.z <= 0 || i.z <= 0) return;
    const glm::vec3 half = glm::normalize(i + o);
    const float density = i.z / kPiF + ggx(alpha, half) * half.z / (4 * glm::dot(half, o));
    sum += reflectedLight(surface, sheen, at, in, out) / density;
  };
  for (int k = 0; k < kLattice; ++k) {
    const LatticePoint point = latticePoint(k);
    add(cosineDirection(point));
    add(glm::reflect(-o, ggxNormal(alpha, point)));
  }
  return sum / static_cast<float>(kLattice);
}

Rgb evenLightTransmitted(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at,
                         glm::vec3 out) {
  const Frame frame(at);
  Rgb sum(0);
  for (int k = 0; k < kLattice; ++k) {
    const glm::vec3 i = cosineDirection(latticePoint(k)), in = -frame.inPicture(i);
    if (in.z < 0) sum += transmittedLight(surface, sheen, at, in, out) * kPiF / i.z;
  }
  return sum / static_cast<float>(kLattice);
}

}  // namespace loomlight
