#include "render/trace/collision.h"

#include <algorithm>
#include <cmath>

#include "core/volume/tangent_spread.h"

namespace loomlight {
namespace {

/// Up to six yarns of at most two components cross a voxel.
constexpr int kMaxComponents = 12;

/// The components of a voxel as a ray in direction d sees them, in world space.
struct VoxelExtinction {
  int count = 0;
  float total = 0;  ///< 1/mm
  struct Entry {
    FibreDistribution fibres;  ///< direction in world space
    YarnOptics optics;
    int yarn;
    float sigma;               ///< 1/mm
  } entries[kMaxComponents];

  VoxelExtinction(const Scene& scene, const VoxelContent& content, const LocalDrape& drape, glm::vec3 direction) {
    const TangentSpread& spread = TangentSpread::table();
    for (int p = 0; p < content.count; ++p) {
      const VoxelContent::Part& part = content.parts[p];
      const int yarn = scene.volume->geometry().yarnIndex(part.system, part.index);
      const YarnOptics& optics = scene.yarns[static_cast<int>(part.system)][yarn];
      for (const Component component : part.components) {
        Entry& entry = entries[count++];
        entry.fibres = component.decode();
        entry.optics = optics;
        entry.yarn = yarn;
        float density = entry.fibres.lengthDensity;
        if (!drape.isometric) {
          float stretch = 1;
          entry.fibres.direction = drape.tangent(entry.fibres.direction, stretch);
          density *= stretch * drape.densityScale;
        }
        const float cosine = glm::dot(direction, entry.fibres.direction);
        const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
        entry.sigma = 2.0f * optics.fibreRadius_mm * density * spread.projectedLength(sine, entry.fibres.spread);
        total += entry.sigma;
      }
    }
  }

  /// One entry, with probability proportional to weight(entry); u in [0, 1).
  template <class Weight>
  const Entry& choose(float u, Weight&& weight) const {
    float sum = 0;
    for (int i = 0; i < count; ++i) sum += weight(entries[i]);
    float rest = u * sum;
    for (int i = 0; i + 1 < count; ++i) {
      rest -= weight(entries[i]);
      if (rest < 0) return entries[i];
    }
    return entries[count - 1];
  }
};

/// A tangent of the fibre that a ray along d hits: the Gaussian about the mean, weighted by how much of a fibre's length
/// the ray sees. Rejection; the number of trials is 1 / I(alpha, s), and events are as rare as I is small.
glm::vec3 projectedTangent(const FibreDistribution& fibres, glm::vec3 direction, Random& random) {
  if (fibres.spread == 0) return fibres.direction;
  constexpr int kTrials = 1000;  // a fibre within 1e-3 rad of the ray; beyond that any tangent of the Gaussian will do
  glm::vec3 tangent = fibres.direction;
  for (int i = 0; i < kTrials; ++i) {
    const float u1 = random.uniform(), u2 = random.uniform();
    tangent = sampleTangent(fibres, u1, u2);
    const float cosine = glm::dot(tangent, direction);
    const float u = random.uniform();
    if (u * u < 1.0f - cosine * cosine) break;
  }
  return tangent;
}

}  // namespace

std::optional<Collision> sampleCollision(const Scene& scene, const Place& from, glm::vec3 direction, Random& random,
                                         TraceCounts& counts) {
  const EventLaw law = scene.fabric->render.eventLaw;
  float opticalDepth = -std::log1p(-random.uniform());
  std::optional<Collision> collision;
  ++counts.rays;
  walkCloth(scene, from, direction, std::numeric_limits<float>::infinity(),
            [&](const VoxelContent& content, float tEnter, float tLeave, const LocalDrape& drape, int tet) {
              ++counts.steps;
              const VoxelExtinction voxel(scene, content, drape, direction);
              const float depth = voxel.total * (tLeave - tEnter);
              if (opticalDepth >= depth) {
                opticalDepth -= depth;
                return true;
              }
              const float t = std::min(tLeave, tEnter + opticalDepth / voxel.total);
              const bool report = law == EventLaw::report;
              const auto& entry = voxel.choose(random.uniform(), [&](const VoxelExtinction::Entry& e) {
                return report ? e.fibres.lengthDensity : e.sigma;
              });
              Collision c;
              c.place = {from.world + t * direction, tet};
              c.distance_mm = t;
              if (report) {
                const float u1 = random.uniform(), u2 = random.uniform();
                c.tangent = sampleTangent(entry.fibres, u1, u2);
              } else {
                c.tangent = projectedTangent(entry.fibres, direction, random);
              }
              c.normal = drape.normal();
              c.optics = entry.optics;
              c.yarn = entry.yarn;
              c.end = content.end;
              c.pick = content.pick;
              collision = c;
              return false;
            });
  if (collision) ++counts.events;
  return collision;
}

float transmittance(const Scene& scene, const Place& from, glm::vec3 direction, float distance, Random& random,
                    TraceCounts& counts) {
  constexpr float kExactDepth = 4.0f;
  const float deepest = kExactDepth - std::log1p(-random.uniform());
  float depth = 0;
  ++counts.rays;
  const bool through =
      walkCloth(scene, from, direction, distance,
                [&](const VoxelContent& content, float tEnter, float tLeave, const LocalDrape& drape, int) {
                  ++counts.steps;
                  depth += VoxelExtinction(scene, content, drape, direction).total * (tLeave - tEnter);
                  return depth < deepest;
                });
  return through ? std::exp(-std::min(depth, kExactDepth)) : 0.0f;
}

}  // namespace loomlight
