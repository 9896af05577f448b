#pragma once

#include <deque>
#include <memory>
#include <string>

#include "render/bvdf/bvdf_cache.h"

namespace loomlight {

/// Tables that have been baked before, in memory and in the cache, to stand in for those that are still to be baked.
class KnownBvdfs {
 public:
  explicit KnownBvdfs(BvdfCache cache) : cache_(std::move(cache)) {}

  /// Keeps the tables of a recipe (bvdfRecipe()) in mind; those of the last kMost.
  void keep(const std::string& recipe, std::shared_ptr<const BvdfSet> set);
  /// Of each yarn of the recipe the table of the yarn that is most like it, among those of equal resolution; which yarn
  /// has which table is the caller's affair, as with BvdfCache. Null where there are none at all.
  std::shared_ptr<const BvdfSet> nearest(const std::string& recipe) const;

 private:
  struct Entry {
    std::string recipe;
    std::shared_ptr<const BvdfSet> set;
  };
  static constexpr size_t kMost = 16;

  BvdfCache cache_;
  std::deque<Entry> entries_;  ///< newest first
};

/// What to expect of tables that are being baked: `own`, drawn towards `prior` as if that had been found by so many
/// rays, fewer and fewer as the bake goes on: `progress` is 0..1, and at 1 it is `own`, to the bit. Both have tables of
/// the same yarns and resolution.
std::shared_ptr<const BvdfSet> drawnTowards(const BvdfSet& own, const BvdfSet& prior, double progress);

}  // namespace loomlight
