#include "app/export/handover/principled.h"

#include <algorithm>
#include <cmath>

#include "render/optics/polynomials.h"

namespace loomlight {
namespace {

constexpr float kNormalReflectance = 0.04f;  ///< of glass of index 1.5

template <class T>
Vec3Of<T> normalised(const Vec3Of<T>& v) {
  return (1 / squareRoot(dot(v, v))) * v;
}
template <class T>
T dot(glm::vec3 a, const Vec3Of<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Distribution of the sheen's fibres, by the sine of the half vector with the normal.
template <class T>
T charlie(float alpha, T sine) {
  const float inverse = 1 / alpha;
  return (2 + inverse) / (2 * kPiF) * optics::exponential(inverse * least(optics::logarithm(sine), T{}));
}

/// D Vc of a sheen.
template <class T>
T sheenLobe(float alpha, T cosineHalf, T cosineIn, T cosineOut) {
  const T sine = squareRoot(most(T{}, 1 - cosineHalf * cosineHalf));
  return charlie(alpha, sine) / (4 * (cosineIn + cosineOut - cosineIn * cosineOut));
}

/// D of GGX, of a half vector in the frame of the surface.
template <class T>
T ggx(glm::vec2 alpha, const Vec3Of<T>& half) {
  const T x = half.x / alpha.x, y = half.y / alpha.y, square = x * x + y * y + half.z * half.z;
  return 1 / (kPiF * alpha.x * alpha.y * square * square);
}

/// D V of GGX; directions in the frame of the surface, above it.
template <class T>
T glossLobe(glm::vec2 alpha, const Vec3Of<T>& in, const Vec3Of<T>& out, const Vec3Of<T>& half) {
  const auto reach = [&](const Vec3Of<T>& v) {
    const T x = alpha.x * v.x, y = alpha.y * v.y;
    return squareRoot(x * x + y * y + v.z * v.z);
  };
  return ggx(alpha, half) * 0.5f / (in.z * reach(out) + out.z * reach(in));
}

float largest(const Rgb& colour) {
  return std::max({colour.r, colour.g, colour.b});
}

using Lanes = Float32x8;
constexpr int kSideBySide = kLanes<Lanes>;
float total(Lanes numbers) {
  float sum = 0;
  for (int lane = 0; lane < kSideBySide; ++lane) sum += numbers[lane];
  return sum;
}

/// Points of the unit square as a place from 0 to 1 and the direction of an azimuth, side by side. They come in pairs
/// that face each other, so that what only tilts between them adds up to nothing.
constexpr int kLattice = 256;
struct LatticePoints {
  Lanes place, azimuthX, azimuthY;
};
using Lattice = std::array<LatticePoints, kLattice / kSideBySide>;
Lattice makeLattice() {
  constexpr float kGolden = 0.6180340f;
  Lattice lattice;
  for (int k = 0; k < kLattice; ++k) {
    const int number = k / 2;
    const auto pair = static_cast<float>(number);
    const float turns = 0.5f * (kGolden * pair + static_cast<float>(k % 2));
    const float azimuth = 2 * kPiF * (turns - std::floor(turns));
    LatticePoints& points = lattice[static_cast<size_t>(k / kSideBySide)];
    const int lane = k % kSideBySide;
    points.place[lane] = 2 * (pair + 0.5f) / kLattice;
    points.azimuthX[lane] = std::cos(azimuth);
    points.azimuthY[lane] = std::sin(azimuth);
  }
  return lattice;
}
const Lattice& lattice() {
  static const Lattice points = makeLattice();
  return points;
}
float meanOverLattice(Lanes sums) {
  return total(sums) / kLattice;
}

/// Spread as projected solid angle over the half of the sky: as dense as the cosine over pi.
Vec3Of<Lanes> cosineDirections(const LatticePoints& points) {
  const Lanes sine = squareRoot(points.place);
  return {sine * points.azimuthX, sine * points.azimuthY, squareRoot(1 - points.place)};
}

/// Spread as GGX's normals are by the area that they cover: as dense as D times the cosine.
Vec3Of<Lanes> ggxNormals(glm::vec2 alpha, const LatticePoints& points) {
  const Lanes slope = squareRoot(points.place / (1 - points.place));
  return normalised<Lanes>({alpha.x * slope * points.azimuthX, alpha.y * slope * points.azimuthY, broadcast<Lanes>(1)});
}

template <class T>
T fifthPower(T x) {
  const T square = x * x;
  return square * square * x;
}

}  // namespace

glm::vec3 flattened(glm::vec3 normal, float strength) {
  return glm::normalize(glm::vec3(strength * normal.x, strength * normal.y, normal.z));
}

SheenAlbedo::SheenAlbedo(float sheenRoughness) {
  constexpr int kAzimuths = 3 * kSideBySide, kCosines = 24;
  const float alpha = sheenRoughness * sheenRoughness;
  struct Azimuths {
    Lanes x, y;
  };
  std::array<Azimuths, kAzimuths / kSideBySide> azimuths;  // the other half is its mirror image
  for (int k = 0; k < kAzimuths; ++k) {
    const float azimuth = kPiF * (static_cast<float>(k) + 0.5f) / kAzimuths;
    Azimuths& some = azimuths[static_cast<size_t>(k / kSideBySide)];
    some.x[k % kSideBySide] = std::cos(azimuth);
    some.y[k % kSideBySide] = std::sin(azimuth);
  }
  for (int i = 0; i <= kSteps; ++i) {
    const float cosine = std::max(0.01f, static_cast<float>(i) / kSteps), sine = std::sqrt(1 - cosine * cosine);
    Lanes sums{};
    for (int j = 0; j < kCosines; ++j) {
      const float c = (static_cast<float>(j) + 0.5f) / kCosines, s = std::sqrt(1 - c * c);
      for (const Azimuths& some : azimuths) {
        const Vec3Of<Lanes> half = normalised<Lanes>({sine + s * some.x, s * some.y, broadcast<Lanes>(cosine + c)});
        sums += c * sheenLobe(alpha, half.z, broadcast<Lanes>(cosine), broadcast<Lanes>(c));
      }
    }
    values_[static_cast<size_t>(i)] = std::min(1.0f, total(sums) * 2 * kPiF / (kAzimuths * kCosines));
  }
}

PointGloss glossAt(const Principled& surface, const PrincipledPoint& at) {
  return {std::clamp(surface.roughness * at.roughnessScale, 0.05f, 1.0f), surface.anisotropy * at.anisotropyScale};
}

glm::vec2 ggxSlopes(const PointGloss& gloss) {
  const float across = gloss.roughness * gloss.roughness;
  return {std::lerp(across, 1.0f, gloss.anisotropy * gloss.anisotropy), across};
}

LitPoint::LitPoint(const Principled& surface, const SheenAlbedo& sheen, const PrincipledPoint& at)
    : surface_(surface),
      sheen_(sheen),
      at_(at),
      mostSheen_(largest(surface.sheenColour)),
      alpha_(ggxSlopes(glossAt(surface, at))) {
  const glm::vec3 axis(at.drawnOut, 0);
  along_ = glm::normalize(axis - glm::dot(axis, at.normal) * at.normal);
  across_ = glm::cross(at.normal, along_);
}

template <class T>
Vec3Of<T> LitPoint::inFrame(const Vec3Of<T>& v) const {
  return {dot(along_, v), dot(across_, v), dot(at_.normal, v)};
}

/// z in the picture, of a direction in the frame of the surface.
template <class T>
T LitPoint::heightInPicture(const Vec3Of<T>& v) const {
  return v.x * along_.z + v.y * across_.z + v.z * at_.normal.z;
}

template <class T>
T LitPoint::leftBySheen(T cosineIn, T cosineOut) const {
  if (mostSheen_ == 0) return broadcast<T>(1);
  return 1 - mostSheen_ * most(sheen_(cosineIn), sheen_(cosineOut));
}

/// Directions in the frame of the surface, above it.
template <class T>
LitPoint::Lobes<T> LitPoint::scattered(const Vec3Of<T>& in, const Vec3Of<T>& out) const {
  const Vec3Of<T> half = normalised(in + out);
  const float f0 = kNormalReflectance * surface_.specular;
  const T fresnel = f0 + (surface_.specular - f0) * fifthPower(1 - least(broadcast<T>(1), dot(half, out)));
  const T left = in.z * leftBySheen(in.z, out.z);
  Lobes<T> lobes{left * fresnel * glossLobe(alpha_, in, out, half), T{}, left * (1 - fresnel) / kPiF};
  if (mostSheen_ > 0) {
    const float alpha = surface_.sheenRoughness * surface_.sheenRoughness;
    lobes.sheen = in.z * sheenLobe(alpha, half.z, in.z, out.z);
  }
  return lobes;
}

template <class T>
Vec3Of<T> LitPoint::sent(const Vec3Of<T>& in, const Vec3Of<T>& out) const {
  const Vec3Of<T> i = inFrame(in), o = inFrame(out);
  const MaskOf<T> isBehind = in.z < 0, isReflected = (in.z >= 0) & (i.z > 0) & (o.z > 0);
  Vec3Of<T> light{};
  if (any(isReflected)) {
    const Lobes<T> lobes = scattered(i, o);
    const auto channel = [&](int c) {
      return isReflected ? lobes.gloss + surface_.sheenColour[c] * lobes.sheen + at_.reflected[c] * lobes.diffuse : T{};
    };
    light = {channel(0), channel(1), channel(2)};
  }
  if (any(isBehind)) {
    const MaskOf<T> isTransmitted = isBehind & (i.z < 0) & (o.z > 0);
    const T lobe = isTransmitted ? -i.z * leftBySheen(-i.z, o.z) / kPiF : T{};
    light = light + Vec3Of<T>{at_.transmitted.r * lobe, at_.transmitted.g * lobe, at_.transmitted.b * lobe};
  }
  return light;
}
template Vec3Of<Float32x8> LitPoint::sent(const Vec3Of<Float32x8>& in, const Vec3Of<Float32x8>& out) const;

Rgb LitPoint::sent(glm::vec3 in, glm::vec3 out) const {
  const Vec3Of<float> light = sent<float>({in.x, in.y, in.z}, {out.x, out.y, out.z});
  return {light.x, light.y, light.z};
}

LightParts LitPoint::evenlyReflected(glm::vec3 out) const {
  const Vec3Of<float> one = inFrame<float>({out.x, out.y, out.z});
  if (one.z <= 0) return {};
  const Vec3Of<Lanes> o{broadcast<Lanes>(one.x), broadcast<Lanes>(one.y), broadcast<Lanes>(one.z)};
  Lobes<Lanes> sums;
  // Looked for in all directions alone, light would be missed in a narrow highlight, and there alone everywhere else:
  // both, each weighted by how dense the two together are (the balance heuristic).
  const auto add = [&](const Vec3Of<Lanes>& i) {
    const auto isSeen = (i.z > 0) & (heightInPicture(i) > 0);
    const Vec3Of<Lanes> half = normalised(i + o);
    const Lanes density = i.z / kPiF + ggx(alpha_, half) * half.z / (4 * dot(half, o));
    const Lobes<Lanes> lobes = scattered(i, o);
    sums.gloss += isSeen ? lobes.gloss / density : Lanes{};
    sums.sheen += isSeen ? lobes.sheen / density : Lanes{};
    sums.diffuse += isSeen ? lobes.diffuse / density : Lanes{};
  };
  for (const LatticePoints& points : lattice()) {
    add(cosineDirections(points));
    const Vec3Of<Lanes> normal = ggxNormals(alpha_, points);
    add(2 * dot(normal, o) * normal - o);
  }
  return {Rgb(meanOverLattice(sums.gloss)) + meanOverLattice(sums.sheen) * surface_.sheenColour,
          meanOverLattice(sums.diffuse)};
}

float LitPoint::evenlyTransmitted(glm::vec3 out) const {
  const float cosineOut = glm::dot(at_.normal, out);
  if (cosineOut <= 0) return 0;
  // Directions are as dense as the cosine over pi, just as a diffuse surface weighs them: each counts 1, less what the
  // sheen takes.
  Lanes sums{};
  for (const LatticePoints& points : lattice()) {
    const Vec3Of<Lanes> i = cosineDirections(points);
    sums += heightInPicture(i) > 0 ? leftBySheen(i.z, broadcast<Lanes>(cosineOut)) : Lanes{};
  }
  return meanOverLattice(sums);
}

}  // namespace loomlight
