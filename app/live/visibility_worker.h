#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/live/mailbox.h"
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
  ~VisibilityWorker();

  /// Tables of this fabric, and the picture of one yarn's. A null fabric: none are wanted.
  void request(std::shared_ptr<const Fabric> fabric, int yarn);
  std::shared_ptr<const BakedVisibility> newest() const;  ///< null before the first; of whatever was asked for last
  Status status() const;

 private:
  struct Wish {
    std::shared_ptr<const Fabric> fabric;
    int yarn = 0;
    std::stop_token stop;
  };
  void loop(std::stop_token stop);
  void fulfil(Wish wish);
  void bake(std::shared_ptr<const Fabric> fabric, std::stop_token wanted, std::string recipe);
  bool serves(Wish newer);
  void publish(std::shared_ptr<const BvdfSet> tables, bool finished);
  void setStatus(Status status);

  std::function<void()> wake_;
  BvdfOptions options_;
  BvdfCache cache_;
  KnownBvdfs known_;  ///< the thread's own
  Mailbox<Wish> wishes_;
  mutable std::mutex mutex_;
  std::stop_source stop_;  ///< of all wishes since the last for nothing
  std::shared_ptr<const BakedVisibility> newest_;
  Status status_;

  // The thread's own:
  std::stop_token ending_;
  Wish wish_;                 ///< the newest that has been looked at
  std::optional<Wish> next_;  ///< taken, but not looked at
  std::string recipe_;        ///< of what is published, or being baked
  uint64_t bake_ = 0;
  bool interrupted_ = false;  ///< the bake of recipe_ was stopped

  std::jthread thread_;  // last: it stops before what it uses is gone
};

}  // namespace loomlight
