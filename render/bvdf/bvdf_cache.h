#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/bvdf/bvdf_set.h"

namespace loomlight {

/// Tables that have been baked before, kept as files in a folder. A table is found by its recipe, a text of all that it
/// depends on; the whole recipe is in the file, so that none is ever mistaken for another. A file that is damaged, of
/// another program or of another machine's byte order is as good as none. Nothing here throws for what the disk does:
/// without a disk the tables are baked again.
class BvdfCache {
 public:
  /// At most `maxBytes` are kept in the folder; those that have not been used for longest go first.
  /// An empty folder name keeps nothing.
  explicit BvdfCache(std::filesystem::path folder, size_t maxBytes = kMaxBytes)
      : folder_(std::move(folder)), maxBytes_(maxBytes) {}
  static constexpr size_t kMaxBytes = size_t{1} << 30;

  /// $XDG_CACHE_HOME/loomlight/bvdf, or ~/.cache/loomlight/bvdf; empty where there is neither.
  static std::filesystem::path userFolder();

  /// Tables and rays; which yarn has which table is the caller's affair.
  std::optional<BvdfSet> find(const std::string& recipe) const;
  void keep(const std::string& recipe, const BvdfSet& set) const;
  /// The recipes of the tables that were used last, newest first, `most` of them. A file that is damaged may be there.
  std::vector<std::string> recipes(size_t most) const;
  /// Whether there is a file for the recipe; what is in it, find() tells.
  bool has(const std::string& recipe) const;
  /// Where the tables of a recipe are kept.
  std::filesystem::path fileOf(const std::string& recipe) const;

 private:
  struct Entry {
    std::filesystem::file_time_type used;
    std::filesystem::path file;
    uintmax_t bytes = 0;
  };
  std::vector<Entry> entries() const;  ///< those used last come first
  void prune(const std::filesystem::path& justWritten) const;

  std::filesystem::path folder_;
  size_t maxBytes_;
};

}  // namespace loomlight
