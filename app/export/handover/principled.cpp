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

/// Points of the unit square as a place from 0 to 1 and the direction of an azimuth. They come in pairs that face each
/// other, so that what only tilts between them adds up to nothing.
constexpr size_t kLattice = 256;
struct LatticePoint {
  float place;
  glm::vec2 azimuth;
};
std::array<LatticePoint, kLattice> makeLattice() {
  constexpr float kGolden = 0.6180340f;
  std::array<LatticePoint, kLattice> lattice;
  for (size_t k = 0; k < kLattice; ++k) {
    const size_t number = k / 2;
    const auto pair = static_cast<float>(number);
    const float turns = 0.5f * (kGolden * pair + static_cast<float>(k % 2));
    const float azimuth = 2 * kPiF * (turns - std::floor(turns));
    lattice[k] = {2 * (pair + 0.5f) / kLattice, {std::cos(azimuth), std::sin(azimuth)}};
  }
  return lattice;
}
const std::array<LatticePoint, kLattice>& lattice() {
  static const std::array<LatticePoint, kLattice> points = makeLattice();
  return points;
}

/// Spread as projected solid angle over the half of the sky: as dense as the cosine over pi.
glm::vec3 cosineDirection(const LatticePoint& point) {
  return {std::sqrt(point.place) * point.azimuth, std::sqrt(1 - point.place)};
}

/// Spread as GGX's normals are by the area that they cover: as dense as D times the cosine.
glm::vec3 ggxNormal(glm::vec2 alpha, const LatticePoint& point) {
  const float slope = std::sqrt(point.place / (1 - point.place));
  return glm::normalize(glm::vec3(slope * alpha * point.azimuth, 1));
}

float fifthPower(float x) {
  const float square = x * x;
  return square * square * x;
}

}  // namespace

glm::vec3 flattened(glm::vec3 normal, float strength) {
  return glm::normalize(glm::vec3(strength * normal.x, strength * normal.y, normal.z));
}

SheenAlbedo::SheenAlbedo(float sheenRoughness) {
  constexpr int kAzimuths = 24, kCosines = 24;
  const float alpha = sheenRoughness * sheenRoughness;
  std::array<glm::vec2, kAzimuths> azimuths;  // the other half is its mirror image
  for (int k = 0; k < kAzimuths; ++k) {
    const float azimuth = kPiF * (static_cast<float>(k) + 0.5f) / kAzimuths;
    azimuths[static_cast<size_t>(k)] = {std::cos(azimuth), std::sin(azimuth)};
  }
  for (int i = 0; i <= kSteps; ++i) {
    const float cosine = std::max(0.01f, static_cast<float>(i) / kSteps);
    const glm::vec3 in(std::sqrt(1 - cosine * cosine), 0, cosine);
    float sum = 0;
    for (int j = 0; j < kCosines; ++j) {
      const float c = (static_cast<float>(j) + 0.5f) / kCosines, s = std::sqrt(1 - c * c);
      for (const glm::vec2 azimuth : azimuths)
        sum += sheenLobe(alpha, glm::normalize(in + glm::vec3(s * azimuth, c)).z, cosine, c) * c;
    }
    values_[static_cast<size_t>(i)] = std::min(1.0f, sum * 2 * kPiF / (kAzimuths * kCosines));
  }
}

float SheenAlbedo::operator()(float cosine) const {
  const float place = std::clamp(cosine, 0.0f, 1.0f) * kSteps;
  const auto below = std::min(static_cast<size_t>(place), size_t{kSteps - 1});
  return std::lerp(values_[below], values_[below + 1], place - static_cast<float>(below));
}

glm::vec2 ggxSlopes(float roughness, float anisotropy) {
  const float across = roughness * roughness;
  return {std::lerp(across, 1.0f, anisotropy * anisotropy), across};
}

LitPoint::LitPoint(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at)
    : surface_(surface),
      sheen_(sheen),
      at_(at),
      mostSheen_(largest(surface.sheenColour)),
      alpha_(ggxSlopes(std::clamp(surface.roughness * at.roughnessScale, 0.05f, 1.0f),
                       surface.anisotropy * at.anisotropyScale)) {
  const glm::vec3 axis(at.drawnOut, 0);
  along_ = glm::normalize(axis - glm::dot(axis, at.normal) * at.normal);
  across_ = glm::cross(at.normal, along_);
}

float LitPoint::leftBySheen(float cosineIn, float cosineOut) const {
  return mostSheen_ == 0 ? 1.0f : 1 - mostSheen_ * std::max(sheen_(cosineIn), sheen_(cosineOut));
}

/// f times the cosine of `in`; directions in the frame of the surface, above it.
LightParts LitPoint::scattered(glm::vec3 in, glm::vec3 out) const {
  const glm::vec3 half = glm::normalize(in + out);
  const float f0 = kNormalReflectance * surface_.specular;
  const float fresnel = f0 + (surface_.specular - f0) * fifthPower(1 - std::min(1.0f, glm::dot(half, out)));
  const float left = in.z * leftBySheen(in.z, out.z), gloss = left * fresnel * glossLobe(alpha_, in, out, half);
  LightParts parts{Rgb(gloss), left * (1 - fresnel) / kPiF};
  if (mostSheen_ > 0) {
    const float alpha = surface_.sheenRoughness * surface_.sheenRoughness;
    parts.gloss += in.z * sheenLobe(alpha, half.z, in.z, out.z) * surface_.sheenColour;
  }
  return parts;
}

Rgb LitPoint::reflected(glm::vec3 in, glm::vec3 out) const {
  const glm::vec3 i = inFrame(in), o = inFrame(out);
  if (i.z <= 0 || o.z <= 0) return Rgb(0);
  const LightParts parts = scattered(i, o);
  return parts.gloss + parts.diffuse * at_.reflected;
}

Rgb LitPoint::transmitted(glm::vec3 in, glm::vec3 out) const {
  const float cosineIn = -glm::dot(at_.normal, in), cosineOut = glm::dot(at_.normal, out);
  if (cosineIn <= 0 || cosineOut <= 0) return Rgb(0);
  return cosineIn * leftBySheen(cosineIn, cosineOut) / kPiF * at_.transmitted;
}

LightParts LitPoint::evenlyReflected(glm::vec3 out) const {
  const glm::vec3 o = inFrame(out);
  LightParts sum;
  if (o.z <= 0) return sum;
  // Looked for in all directions alone, light would be missed in a narrow highlight, and there alone everywhere else:
  // both, each weighted by how dense the two together are (the balance heuristic).
  const auto add = [&](glm::vec3 i) {
    if (i.z <= 0 || inPicture(i).z <= 0) return;
    const glm::vec3 half = glm::normalize(i + o);
    const float density = i.z / kPiF + ggx(alpha_, half) * half.z / (4 * glm::dot(half, o));
    const LightParts parts = scattered(i, o);
    sum.gloss += parts.gloss / density;
    sum.diffuse += parts.diffuse / density;
  };
  for (const LatticePoint& point : lattice()) {
    add(cosineDirection(point));
    add(glm::reflect(-o, ggxNormal(alpha_, point)));
  }
  return {sum.gloss / static_cast<float>(kLattice), sum.diffuse / static_cast<float>(kLattice)};
}

float LitPoint::evenlyTransmitted(glm::vec3 out) const {
  const float cosineOut = glm::dot(at_.normal, out);
  float sum = 0;
  if (cosineOut <= 0) return sum;
  // Directions are as dense as the cosine over pi, just as a diffuse surface weighs them: each counts 1, less what the
  // sheen takes.
  for (const LatticePoint& point : lattice())
    if (const glm::vec3 i = cosineDirection(point); inPicture(i).z > 0) sum += leftBySheen(i.z, cosineOut);
  return sum / static_cast<float>(kLattice);
}

}  // namespace loomlight
