#pragma once

#include <filesystem>
#include <optional>

namespace loomlight {

/// A file that says by its lock that a program is still running: the system opens it however the program ends.
class FileLock {
 public:
  /// Makes the file and locks it; nothing where it cannot be made.
  static std::optional<FileLock> make(const std::filesystem::path& file);
  /// Whether some program, be it this one, holds the file's lock. Nobody does where the file system knows no locks.
  static bool isHeld(const std::filesystem::path& file);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();  ///< unlocks the file, and leaves it

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace loomlight
