#pragma once

#include <cmath>

#include "core/volume/pool/tangent_spread.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/media/cloth_walk.h"
#include "render/scene/trace_data.h"

namespace loomlight {

/// A component's fibres as they lie in the world.
inline FibreDistribution inWorld(FibreDistribution fibres, const LocalDrape& drape) {
  if (!drape.isometric) {
    float stretch = 1;
    fibres.direction = drape.tangent(fibres.direction, stretch);
    fibres.lengthDensity *= stretch * drape.densityScale;
  }
  return fibres;
}

/// What a ray in direction d meets in one voxel: the extinction of every component, sigma_i(d) = 2 r lambda_i
/// I(angle(d, m_i), s_i) (Eqs. 6-9 of the report). Refers to the components it was given.
/// Cost: about one decoding, one dot product and one table look-up a component.
class VoxelExtinction {
 public:
  struct Entry {  // no initialisers: a voxel has room for twelve, and hardly ever more than one
    const Component* component;
    const YarnOptics* optics;
    Thread thread;
    int yarn;       ///< index into Fabric::yarns
    float density;  ///< lambda in the world, 1/mm^2
    float sigma;    ///< 1/mm
  };

  explicit VoxelExtinction(glm::vec3 direction) : direction_(direction) {}
  VoxelExtinction(const TraceData& cloth, const VoxelContent& content, const LocalDrape& drape, glm::vec3 direction)
      : VoxelExtinction(cloth, content, drape, direction,
                        [](const FibreDistribution&, const YarnOptics&, Thread) { return 1.0f; }) {}

  /// With a factor on each component's extinction: factor(fibres in the world, optics, whose they are).
  template <class Factor>
  VoxelExtinction(const TraceData& cloth, const VoxelContent& content, const LocalDrape& drape, glm::vec3 direction,
                  Factor&& factor)
      : VoxelExtinction(direction) {
    for (int p = 0; p < content.count; ++p) {
      const VoxelContent::Part& part = content.parts[p];
      const YarnOptics& optics = cloth.yarns[static_cast<int>(part.system)][part.yarn];
      const Thread thread{part.system, part.index};
      for (const Component& component : part.components) add(component, drape, optics, thread, part.yarn, factor);
    }
  }

  void add(const Component& component, const LocalDrape& drape, const YarnOptics& optics, Thread thread, int yarn) {
    add(component, drape, optics, thread, yarn,
        [](const FibreDistribution&, const YarnOptics&, Thread) { return 1.0f; });
  }
  template <class Factor>
  void add(const Component& component, const LocalDrape& drape, const YarnOptics& optics, Thread thread, int yarn,
           Factor&& factor) {
    const FibreDistribution fibres = inWorld(component.decode(), drape);
    const float cosine = glm::dot(direction_, fibres.direction);
    const float sineSquared = std::max(0.0f, 1.0f - cosine * cosine);
    const float whole = 2.0f * optics.fibreRadius_mm * fibres.lengthDensity *
                        TangentSpread::table().projectedLengthOfSquare(sineSquared, fibres.spread);
    const float sigma = whole * factor(fibres, optics, thread);
    entries_[count_++] = {&component, &optics, thread, yarn, fibres.lengthDensity, sigma};
    total_ += sigma;
    whole_ += whole;
    const float solid = kPiSingle * optics.fibreRadius_mm * optics.fibreRadius_mm * fibres.lengthDensity;
    solid_ += solid;
    if (optics.packed) packed_ += solid;
  }

  float total() const { return total_; }  ///< 1/mm
  float whole() const { return whole_; }  ///< 1/mm, before the factors
  /// How much of the voxel is fibre, 0.. (overlapping fibres count twice); and of packed yarns alone.
  float solid() const { return solid_; }
  float packed() const { return packed_; }

  /// The component that a collision is with; u in [0, 1). EventLaw::report chooses by density alone (Eq. 12), which is
  /// biased where components are seen at different angles.
  const Entry& choose(float u, EventLaw law) const {
    const auto weight = [law](const Entry& e) { return law == EventLaw::report ? e.density : e.sigma; };
    float sum = 0;
    for (int i = 0; i < count_; ++i) sum += weight(entries_[i]);
    float rest = u * sum;
    for (int i = 0; i + 1 < count_; ++i) {
      rest -= weight(entries_[i]);
      if (rest < 0) return entries_[i];
    }
    return entries_[count_ - 1];
  }

 private:
  static constexpr float kPiSingle = static_cast<float>(kPi);
  static constexpr int kMaxEntries = 12;  // up to six yarns of at most two components cross a voxel
  glm::vec3 direction_;
  int count_ = 0;
  float total_ = 0, whole_ = 0, solid_ = 0, packed_ = 0;
  Entry entries_[kMaxEntries];
};

}  // namespace loomlight
