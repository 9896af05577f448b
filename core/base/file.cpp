#include "core/base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/utf8.h"

// How it works. A file is written beside the one that it replaces, under a name of its own, brought to the disk
// (fsync), and takes its place by a rename, after which the folder is brought to the disk too: whatever happens,
// either the whole old file is there or the whole new one. Links are followed, permissions are kept, and where
// writing is stopped or fails, nothing is left behind. Reading is bounded, and refuses what is no regular file: a
// pipe would hang.

namespace loomlight {
namespace {

[[noreturn]] void fail(const std::string& file, const char* what) {
  const int reason = errno;
  throw InputError(fmt::format("{}: {}: {}", file, what, std::strerror(reason)));
}

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

/// Opens a new file beside the target; with a name of its own, so that two writers never share one, and no longer than
/// names may be, however long the target's is.
int openBeside(const std::filesystem::path& target, std::string& name) {
  constexpr int kAttempts = 16;
  constexpr size_t kLongest = 60;
  const std::string whole = target.filename().string();
  const std::string beginning = (target.parent_path() / wholeCharacters(whole, kLongest)).string();
  auto number = static_cast<uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
  int fd = -1;
  for (int i = 0; i < kAttempts && fd < 0; ++i) {
    number = mixBits(number + static_cast<uint64_t>(::getpid()));
    name = fmt::format("{}.{:016x}.tmp", beginning, number);
    fd = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (fd < 0 && errno != EEXIST) break;
  }
  return fd;
}

/// Returns early, and well, once it is to stop.
bool writeAll(int fd, std::string_view content, const std::stop_token& stop) {
  constexpr size_t kPiece = 1 << 20;
  while (!content.empty() && !stop.stop_requested()) {
    const ssize_t n = ::write(fd, content.data(), std::min(content.size(), kPiece));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    content.remove_prefix(static_cast<size_t>(n));
  }
  return true;
}

/// The file that is replaced hands on its permissions.
bool keepPermissions(int fd, const std::string& target) {
  struct stat old{};
  return ::stat(target.c_str(), &old) != 0 || ::fchmod(fd, old.st_mode & 07777) == 0;
}

}  // namespace

std::string readFile(const std::string& file, size_t maxBytes) {
  // Without O_NONBLOCK, opening a pipe that nobody writes to would hang.
  const Descriptor fd(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (fd.get() < 0) fail(file, "cannot be opened");
  struct stat status{};
  if (::fstat(fd.get(), &status) != 0) fail(file, "cannot be read");
  if (!S_ISREG(status.st_mode)) throw InputError(file + ": expected a regular file");
  std::string content;
  const auto tooLarge = [&] {
    return InputError(fmt::format("{}: expected a file of at most {} MB", file, maxBytes / 1'000'000));
  };
  if (static_cast<size_t>(status.st_size) > maxBytes) throw tooLarge();
  content.resize(static_cast<size_t>(status.st_size) + 1);  // one more, to see the end of the file
  size_t length = 0;
  for (;;) {
    if (length == content.size()) content.resize(content.size() * 2);
    const ssize_t n = ::read(fd.get(), content.data() + length, content.size() - length);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(file, "cannot be read");
    if (n == 0) break;
    length += static_cast<size_t>(n);
    if (length > maxBytes) throw tooLarge();
  }
  content.resize(length);
  return content;
}

void expectWritable(const std::string& file) {
  std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (folder.empty()) folder = ".";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw InputError(fmt::format("{}: expected a folder that exists, '{}' is none", file, folder.string()));
  struct stat status{};
  const bool exists = ::stat(file.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail(file, "cannot be written");  // such as a symbolic link to itself
  if (exists && !S_ISREG(status.st_mode))
    throw InputError(file + ": cannot be written: expected a regular file, or none yet");
  // A rename would replace a write-protected file without a word.
  if (exists && ::access(file.c_str(), W_OK) != 0) fail(file, "cannot be written");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(file, "cannot be written into its folder");
}

std::filesystem::path replacedBy(const std::string& file) {
  std::error_code none;
  const std::filesystem::path real = std::filesystem::canonical(file, none);
  return none ? std::filesystem::path(file) : real;
}

void syncFolder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) (void)::fsync(fd.get());
}

bool writeFileAtomically(const std::string& file, std::string_view content, const std::stop_token& stop) {
  expectWritable(file);
  const std::string target = replacedBy(file).string();
  std::string name;
  bool written = false;
  {
    const Descriptor fd(openBeside(target, name));
    if (fd.get() < 0) fail(file, "cannot be written");
    written = writeAll(fd.get(), content, stop) && keepPermissions(fd.get(), target) && ::fsync(fd.get()) == 0;
  }
  if (written && stop.stop_requested()) {
    ::unlink(name.c_str());
    return false;
  }
  if (!written || ::rename(name.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    ::unlink(name.c_str());
    errno = reason;
    fail(file, "cannot be written");
  }
  syncFolder(target);
  return true;
}

}  // namespace loomlight
