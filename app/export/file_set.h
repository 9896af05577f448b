#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/file_lock.h"

namespace loomlight {

/// Files that belong together. They are made in a folder of their own beside the old ones, and put in their places one
/// after the other when all of them are whole. A full disk leaves the old ones. A kill leaves each file as it was or as
/// it is now, never torn; a kill in the instant in which they are put in their places leaves some of either, and the
/// others new and whole in the folder where they were made. Sets of one name that are made at the same time do not
/// disturb one another: every file is then of one of them.
class FileSet {
 public:
  /// `folder`: where they will be; it is there. `name`: of what they are files of; what killed programs have left of it
  /// is removed. Throws InputError where nothing can be made in the folder.
  FileSet(const std::string& folder, const std::string& name);
  ~FileSet();  ///< what is not in its place is gone
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  /// Where to make a file; `name` is within the folder, and may have a folder in it.
  std::string add(const std::string& name);
  /// Where a file is made that was added, or one that is for the making alone and goes with the set.
  std::string pathOf(const std::string& name) const { return scratch_ + "/" + name; }
  /// Puts all that were added in their places. Throws InputError before the first where one cannot be.
  void place() const;

 private:
  std::string folder_, scratch_;
  std::optional<FileLock> running_;  ///< tells others that the scratch is in use; none where there are no locks
  std::vector<std::string> names_;
};

}  // namespace loomlight
