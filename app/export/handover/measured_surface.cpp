#include "app/export/handover/measured_surface.h"

#include <algorithm>
#include <cmath>

#include "app/export/task_part.h"
#include "core/fabric/model/validate.h"
#include "render/transport/half_dome.h"
#include "render/transport/make_medium.h"

namespace loomlight {
namespace {

constexpr double kRadians = kPi / 180;
constexpr int kAzimuths = 16, kInclinations = 8;

/// Where parallel light comes from: an angle from the normal of the side that it falls on, and an azimuth.
struct Incidence {
  double angle_deg = 0, azimuth_deg = 0;
};

constexpr Incidence kOnto[] = {{0, 0},  {30, 0},  {30, 90},  {30, 180}, {30, 270},
                               {60, 0}, {60, 90}, {60, 180}, {60, 270}};
constexpr Incidence kThrough[] = {{0, 0}, {45, 0}, {45, 90}, {45, 180}, {45, 270}};

glm::vec3 direction(double angle_deg, double azimuth_deg, bool underneath) {
  const double sine = std::sin(angle_deg * kRadians), cosine = std::cos(angle_deg * kRadians);
  return glm::vec3(sine * std::cos(azimuth_deg * kRadians), sine * std::sin(azimuth_deg * kRadians),
                   underneath ? -cosine : cosine);
}

/// From the world to the picture of a side: the back's is turned over about y.
glm::vec3 inPicture(glm::vec3 v, ClothSide side) {
  return side == ClothSide::front ? v : glm::vec3(-v.x, v.y, -v.z);
}

/// The patch, built once for all lights.
class Goniometer {
 public:
  Goniometer(Fabric fabric, int samples) : fabric_(std::move(fabric)), samples_(samples) {
    fabric_.light = Light{};
    fabric_.light.kind = LightKind::directional;
    fabric_ = halfDomePatch(std::move(fabric_), HalfDomeGrid{kAzimuths, kInclinations});
    validate(fabric_, "the patch");
  }

  /// False when stopped.
  bool build(double limit_bytes, const Task& task) {
    built_ = makeScene(std::make_shared<const Fabric>(fabric_), partOf(task, 0, 0.5));
    medium_ = built_ ? makeMedium(*built_, {limit_bytes, FibreExtent::automatic}, partOf(task, 0.5, 1)) : nullptr;
    return medium_ != nullptr;
  }

  /// Adds what a side shows of light that falls on it, or on the other side. False when stopped.
  bool observe(ClothSide side, bool isThrough, const Incidence& from, std::vector<Observation>& seen,
               const Task& task) const {
    const bool underneath = side == ClothSide::back;
    const bool litUnderneath = underneath != isThrough;
    Fabric lit = fabric_;
    lit.light.azimuth_deg = from.azimuth_deg;
    lit.light.elevation_deg = (litUnderneath ? -1 : 1) * (90 - from.angle_deg);
    const double unit = paperRadiance(lit.light);
    const HalfDomeGrid grid{kAzimuths, kInclinations, underneath};
    // Twice with half the paths: how far the two differ is how much noise there is.
    std::optional<HalfDomeMeasure> halves[2];
    for (int i = 0; i < 2; ++i) {
      lit.render.seed = fabric_.render.seed + static_cast<uint64_t>(i);
      const auto scene = makeScene(std::make_shared<const Fabric>(lit), task, built_.get());
      halves[i] = scene ? measureHalfDome(*scene, *medium_, grid, std::max(1, samples_ / 2),
                                          partOf(task, 0.5 * i, 0.5 * (i + 1)))
                        : std::nullopt;
      if (!halves[i]) return false;
    }
    const glm::vec3 in = inPicture(direction(from.angle_deg, from.azimuth_deg, litUnderneath), side);
    const double step = 0.5 * kPi / kInclinations;
    for (int j = 0; j < kInclinations; ++j) {
      // Of a ring between two inclinations, over that of the half-dome: squares of sines.
      const double share = std::pow(std::sin((j + 1) * step), 2) - std::pow(std::sin(j * step), 2);
      for (int i = 0; i < kAzimuths; ++i) {
        const glm::vec3 out = inPicture(direction(grid.inclination_deg(j), grid.azimuth_deg(i), underneath), side);
        const auto camera = static_cast<size_t>(j) * kAzimuths + static_cast<size_t>(i);
        const auto scale = static_cast<float>(0.5 / unit);
        const Rgb mean = scale * (halves[0]->radiance[camera] + halves[1]->radiance[camera]);
        const Rgb spread = scale * (halves[0]->radiance[camera] - halves[1]->radiance[camera]);
        seen.push_back({in, out, mean, static_cast<float>(share / kAzimuths), glm::dot(spread, spread) / 3});
      }
    }
    return true;
  }

 private:
  Fabric fabric_;
  int samples_;
  std::shared_ptr<const Scene> built_;
  std::unique_ptr<const Medium> medium_;
};

}  // namespace

std::optional<MeasuredSurface> measuredSurface(const Fabric& fabric, int samples, double limit_bytes,
                                               const Task& task) {
  constexpr double kBuilt = 0.1;  // of the progress
  Goniometer goniometer(fabric, samples);
  if (!goniometer.build(limit_bytes, partOf(task, 0, kBuilt))) return std::nullopt;
  MeasuredSurface measured;
  const double lights = 2 * static_cast<double>(std::size(kOnto) + std::size(kThrough));
  int done = 0;
  const auto all = [&](ClothSide side, bool isThrough, std::span<const Incidence> from,
                       std::vector<Observation>& seen) {
    return std::all_of(from.begin(), from.end(), [&](const Incidence& one) {
      const double begin = kBuilt + (1 - kBuilt) * done / lights, end = kBuilt + (1 - kBuilt) * ++done / lights;
      return goniometer.observe(side, isThrough, one, seen, partOf(task, begin, end));
    });
  };
  for (const ClothSide side : {ClothSide::front, ClothSide::back}) {
    MeasuredSide& of = side == ClothSide::front ? measured.front : measured.back;
    if (!all(side, false, kOnto, of.reflected) || !all(side, true, kThrough, of.transmitted)) return std::nullopt;
  }
  return measured;
}

Rgb albedoAlongNormal(const std::vector<Observation>& seen) {
  Rgb sum(0);
  for (const Observation& one : seen)
    if (std::abs(one.in.z) > 0.9999f) sum += one.weight * one.factor;
  return sum;
}

void scaleTo(const Rgb& albedo, std::vector<Observation>& seen) {
  const Rgb scale = quotient(albedo, albedoAlongNormal(seen));
  for (Observation& one : seen) {
    one.factor *= scale;
    one.variance *= glm::dot(scale, scale) / 3;
  }
}

// A path of light can be walked either way. A map shows light of half the sky that leaves along the side's own normal.
// Walked the other way that is light which arrives along this normal and leaves to half the sky: to the same half where
// the map is of reflected light. Where it is of transmitted light it leaves at the other side. So the front's map of
// transmitted light belongs to what the back was seen to send of light along the front's normal, and what the front was
// seen to send of light along the back's normal belongs to the back's map.
void scaleToMaps(const MeanColours& front, const MeanColours& back, MeasuredSurface& measured) {
  scaleTo(front.reflected, measured.front.reflected);
  scaleTo(back.reflected, measured.back.reflected);
  scaleTo(front.transmitted, measured.back.transmitted);
  scaleTo(back.transmitted, measured.front.transmitted);
}

}  // namespace loomlight
