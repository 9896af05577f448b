#pragma once

#include <cstddef>
#include <memory>

#include "core/base/task.h"
#include "render/media/fibre_rays.h"
#include "render/scene/fibre_extent.h"

namespace loomlight {

class FibreBvh;

/// The cloth fibre by fibre: every strand of the piece as Embree round curves, bent onto the drape; or of a flat piece
/// one repeat and copies of it; or brick by brick, each laid once for all cells that are like it. No statistics: it is
/// the ground truth that the volume is measured against. The same strands, lobes, lights and bookkeeping.
///
/// Where light sets out again is part of the claim. Of packed fibres (FibreLayout::packed), which do not overlap, it
/// leaves from the point where its mode comes out of the fibre. Of fibres laid at random, which do overlap (the
/// report's), it leaves from where it came in, because the way through would start it inside neighbours; that costs
/// dense yarns up to 4 % of their events. Either way the fibre it leaves is not met again within three radii, and
/// surfaces are met from outside only.
class FibreMedium final : public Medium {
 public:
  /// Throws InputError, saying how much it would take, where what planFibres() estimates is beyond the limit, and where
  /// that does. Null when stopped.
  static std::unique_ptr<const FibreMedium> build(std::shared_ptr<const TraceData> cloth, const FibreOptions& options,
                                                  const Task& task);
  /// By the bricks of a cloth that has any (TraceData::fibres): made as rays come to them, for cloth of any size and on
  /// every drape.
  explicit FibreMedium(std::shared_ptr<const TraceData> cloth);
  ~FibreMedium() override;

  const FibreSize& size() const { return size_; }  ///< as it was estimated; of no use where bricks are made
  size_t segments() const;                         ///< that are laid; 0 of bricks, here and below
  size_t geometryBytes() const;
  size_t acceleratorBytes() const;  ///< as Embree reports its allocations

  std::unique_ptr<MediumBatch> batch(size_t paths) const override;

  // What a batch is made of:
  const TraceData& cloth() const { return *cloth_; }
  std::unique_ptr<FibreRays> rays() const;  ///< for one thread; the medium must outlive them

 private:
  FibreMedium(std::shared_ptr<const TraceData> cloth, const FibreSize& size, std::unique_ptr<const FibreBvh> bvh);

  std::shared_ptr<const TraceData> cloth_;
  FibreSize size_;
  std::unique_ptr<const FibreBvh> bvh_;  ///< null: bricks
};

}  // namespace loomlight
