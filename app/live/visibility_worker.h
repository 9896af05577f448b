#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/live/worker.h"
#include "core/base/stopwatch.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/bvdf/known_bvdfs.h"
#include "render/film/image.h"

namespace loomlight {

/// Tables of local visibility, ready or on their way.
struct BakedVisibility {
  std::shared_ptr<const BvdfSet> tables;
  uint64_t bake = 0;      ///< counts up; equal ones are of the same yarns, later ones made of more rays
  uint64_t rays = 0;      ///< of the bake itself; 0 while all is borrowed
  bool finished = false;  ///< nothing better will come of this bake
  int yarn = 0;           ///< of the picture
  Pixels8 picture;        ///< of that yarn's table, as bvdfSquares() lays it out in kPictureColumns
};

/// Whether a picture that is traced with older tables is to take newer ones: those of other yarns, those that are
/// finished, and on the way there those made of four times the rays, which have half the noise.
bool worthTaking(const BakedVisibility& newer, const BakedVisibility& older);

/// Bakes the tables of local visibility of the newest fabric on a thread of its own, at low priority, and shows them as
/// they become better; what a fabric has been baked for once comes from the cache. Until its own are good, the tables
/// of the yarns most like its own that have been baked before stand in; they leave no trace in the finished ones. No
/// call here waits.
class VisibilityWorker {
 public:
  static constexpr int kPictureColumns = 4;

  struct Status {
    bool baking = false;
    bool borrowing = false;  ///< baking, and similar yarns stand in
    double progress = 0;
    std::string error;
  };

  VisibilityWorker(std::function<void()> wake, BvdfOptions options, BvdfCache cache);

  /// Tables of this fabric, and the picture of one yarn's. A null fabric: none are wanted.
  void request(std::shared_ptr<const Fabric> fabric, int yarn);
  std::shared_ptr<const BakedVisibility> newest() const;  ///< null before the first; of whatever was asked for last
  Status status() const;

 private:
  struct Wish {
    std::shared_ptr<const Fabric> fabric;
    int yarn = 0;
  };
  struct Result {
    std::shared_ptr<const BakedVisibility> baked;  ///< the newest
    Status status;
  };
  using Baking = Worker<Wish, Result>;
  Result fulfil(const Wish& wish, Baking::Job& job);
  bool isBakedFor(const Fabric& fabric) const;
  void bake(Baking::Job& job);
  bool servesNewer(Baking::Job& job);
  void keep(const std::shared_ptr<const BvdfSet>& tables, bool finished);

  BvdfOptions options_;

  // The thread's own:
  BvdfCache cache_;
  KnownBvdfs known_;
  Wish wish_;                            ///< the newest that has been looked at
  std::string recipe_;                   ///< of what is published, or being baked
  std::shared_ptr<const Fabric> baked_;  ///< a fabric of that recipe
  uint64_t bake_ = 0;
  bool interrupted_ = false;  ///< the bake of recipe_ was stopped
  std::shared_ptr<const BakedVisibility> newest_;

  Baking worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
