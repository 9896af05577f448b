#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace loomlight {
namespace {

constexpr int kNone = -1;

}  // namespace

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, kNone)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ != kNone) ::close(descriptor_);
}

std::optional<FileLock> FileLock::make(const std::filesystem::path& file) {
  FileLock lock(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NONBLOCK, 0600));
  if (lock.descriptor_ == kNone || ::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  return lock;
}

bool FileLock::isHeld(const std::filesystem::path& file) {
  // Writing is asked for as file systems of a network lock nothing else.
  const FileLock other(::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
  return other.descriptor_ != kNone && ::flock(other.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace loomlight
