#pragma once

#include <functional>
#include <memory>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/bvdf/bvdf_cache.h"
#include "render/bvdf/bvdf_set.h"

namespace loomlight {

class BvdfPatch;
class BvdfCounts;
struct Scene;

struct BvdfOptions {
  BvdfResolution resolution;
  uint64_t rays = 2'000'000;  ///< shadow rays for each yarn, about
};

/// Bakes the BVDFs of a fabric, pass by pass; the tables are usable after any number of passes, and depend on the
/// fabric and the passes alone, not on threads or on how passes are split over calls. Eye rays come in evenly over both
/// sides of a flat patch and over stratified directions; each that meets a fibre sends out kShadowRays, stratified over
/// the sphere in the frame of the event. Many eye rays of few shadow rays each: bins that share eye rays share their
/// noise, and then no filter helps. A shadow ray sets out where the fibre tracer's would, and must not be stopped
/// within the cell.
class BvdfBaker {
 public:
  static constexpr int kShadowRays = 32;

  /// Builds the patch. Null when stopped; throws InputError where it would not fit into memory. With many yarns and a
  /// fine resolution all yarns share one table, as in the report.
  static std::unique_ptr<BvdfBaker> begin(const Fabric& fabric, BvdfResolution resolution, const Task& task);
  ~BvdfBaker();

  /// False when stopped; a pass that was not finished leaves no trace. About 1e5 shadow rays a pass.
  bool advance(int passes, const Task& task);
  int passes() const { return passes_; }
  uint64_t rays() const;  ///< shadow rays so far
  std::shared_ptr<const BvdfSet> tables() const;

 private:
  struct Shadow;
  BvdfBaker(std::unique_ptr<const BvdfPatch> patch, BvdfResolution resolution, std::vector<int> classes);
  std::vector<Shadow> traceBlock(uint64_t block) const;

  std::unique_ptr<const BvdfPatch> patch_;
  BvdfResolution resolution_;
  std::vector<int> tableOfYarn_;   ///< per yarn of the fabric
  std::vector<int> tableOfClass_;  ///< per yarn of the patch
  std::vector<HotSpot> hotSpots_;  ///< per table, as counts_
  std::vector<BvdfCounts> counts_;
  int passes_ = 0;
};

/// All that the tables depend on, as a text: the key of the cache.
std::string bvdfRecipe(const Fabric& fabric, const BvdfOptions& options);

/// The tables of a fabric: out of the cache, or baked and put there. Null when stopped. `afterPass` is called by the
/// caller's thread after each pass but the last, whose tables are returned, with tables that can be used already.
std::shared_ptr<const BvdfSet> bakeBvdf(const Fabric& fabric, const BvdfOptions& options, const BvdfCache& cache,
                                        const Task& task, const std::function<void(const BvdfBaker&)>& afterPass = {});

/// What is expected before any ray was traced, to begin with: the hot-spot law of each yarn of the scene.
std::shared_ptr<const BvdfSet> expectedBvdf(const Scene& scene, BvdfResolution resolution);

}  // namespace loomlight
