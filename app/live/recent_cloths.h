#pragma once

#include <deque>
#include <memory>

#include "app/live/refinement.h"
#include "render/bvdf/bvdf_set.h"

namespace loomlight {

/// A cloth as the builder made it, and the tables that its medium was made with.
struct BuiltCloth {
  Traceable traceable;
  std::shared_ptr<const BvdfSet> visibility;
};

/// The cloths that were built last, so that to undo, to redo, or to go to and fro between two settings builds nothing
/// anew. Cloths of one volume count as one: the newest.
class RecentCloths {
 public:
  /// `budget_bytes`: what cloths may take that are not the newest: volumes, bricks of fibres that close-ups have made,
  /// and drapes (without their trees for rays, a third as large), as far as they are not shared. Explicit fibres in one
  /// tree are kept of the newest alone.
  explicit RecentCloths(size_t budget_bytes) : budget_bytes_(budget_bytes) {}

  /// A cloth that another is made from, and what the edit between them has put out of date.
  struct Base {
    BuiltCloth cloth;
    Changes edit;
  };
  /// What a cloth of this fabric is best made from: the newest whose volume and shell it can have as they are, or else
  /// the newest. One of null pointers where there is none.
  Base baseFor(const Fabric& fabric) const;
  /// Makes it the newest; the oldest are let go until the budget is kept. It must have a scene.
  void keep(BuiltCloth cloth);

  size_t count() const { return entries_.size(); }
  size_t bytes() const { return bytes_; }  ///< kept for all but the newest, at most

 private:
  struct Entry {
    BuiltCloth cloth;
    size_t bytes = 0;  ///< that the next newer one does not share
    const TraceData& data() const { return *cloth.traceable.scene->cloth; }
  };
  void count(size_t i);

  static constexpr size_t kMost = 64;  ///< cloths, however small
  size_t budget_bytes_;
  size_t bytes_ = 0;
  std::deque<Entry> entries_;  ///< newest first
};

}  // namespace loomlight
