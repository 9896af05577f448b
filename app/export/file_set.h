#pragma once

#include <string>
#include <vector>

namespace loomlight {

/// Files that belong together. They are made in a folder of their own beside the old ones, and put in their places when
/// all of them are whole: a full disk or a kill leaves the old ones, but in the instant in which they are renamed.
class FileSet {
 public:
  /// `folder`: where they will be; it is there. `name`: of what they are files of; what a killed program has left of it
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
  std::vector<std::string> names_;
};

}  // namespace loomlight
