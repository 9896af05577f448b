#include "app/export/file_set.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/utf8.h"

namespace loomlight {
namespace fs = std::filesystem;

namespace {

void makeFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw InputError(fmt::format("{}: expected a folder that can be made, got: {}", folder.string(), failed.message()));
}

fs::path lockIn(const fs::path& scratch) {
  return scratch / ".lock";
}

/// A lock shows under its name only when it is held: whoever finds it free knows that its program has ended.
std::optional<FileLock> lock(const fs::path& scratch) {
  const fs::path beside = scratch / ".lock.new";
  std::optional<FileLock> made = FileLock::make(beside);
  std::error_code failed;
  if (made) fs::rename(beside, lockIn(scratch), failed);
  return made;
}

/// All that is in the folder.
std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    entries.push_back(it->path());
  return entries;
}

/// The lock goes last: a program that is killed meanwhile leaves what the next one still knows for a scratch of it.
void removeScratch(const fs::path& scratch) {
  std::error_code ignored;
  for (const fs::path& entry : entriesOf(scratch))
    if (entry != lockIn(scratch)) fs::remove_all(entry, ignored);
  fs::remove_all(scratch, ignored);
}

/// Removes the scratches of this beginning whose programs were killed.
void sweep(const fs::path& folder, const std::string& beginning) {
  for (const fs::path& entry : entriesOf(folder)) {
    std::error_code unknown;
    if (entry.filename().string().starts_with(beginning) && fs::exists(lockIn(entry), unknown) &&
        !FileLock::isHeld(lockIn(entry)))
      removeScratch(entry);
  }
}

/// The file that is replaced hands on its permissions. Throws InputError where a link has led to another disk, as files
/// can be renamed within one alone.
void takeOver(const fs::path& made, const fs::path& target) {
  struct stat ours{}, folder{}, old{};
  const fs::path parent = target.has_parent_path() ? target.parent_path() : ".";
  if (::stat(made.c_str(), &ours) == 0 && ::stat(parent.c_str(), &folder) == 0 && ours.st_dev != folder.st_dev)
    throw InputError(
        fmt::format("{}: expected a file on the disk of the folder that it is linked from", target.string()));
  if (::stat(target.c_str(), &old) == 0) ::chmod(made.c_str(), old.st_mode & 07777);
}

}  // namespace

FileSet::FileSet(const std::string& folder, const std::string& name) : folder_(folder.empty() ? "." : folder) {
  constexpr size_t kLongest = 100;  // bytes of the name; those behind them would make the folder's name too long
  makeFolder(folder_);
  const std::string beginning = fmt::format(".{}.unfinished-", wholeCharacters(name, kLongest));
  sweep(folder_, beginning);
  scratch_ = (fs::path(folder_) / (beginning + "XXXXXX")).string();
  if (::mkdtemp(scratch_.data()) == nullptr)
    throw InputError(fmt::format("{}: expected a folder in which files can be made, got: {}", folder_,
                                 std::generic_category().message(errno)));
  running_ = lock(scratch_);
}

FileSet::~FileSet() {
  removeScratch(scratch_);
}

std::string FileSet::add(const std::string& name) {
  makeFolder(fs::path(pathOf(name)).parent_path());
  names_.push_back(name);
  return pathOf(name);
}

void FileSet::place() const {
  std::vector<fs::path> targets;
  for (const std::string& name : names_) {
    const fs::path to = fs::path(folder_) / name;
    makeFolder(to.parent_path());
    expectWritable(to.string());
    targets.push_back(replacedBy(to.string()));
    takeOver(pathOf(name), targets.back());
  }
  for (size_t i = 0; i < names_.size(); ++i) {
    std::error_code failed;
    fs::rename(pathOf(names_[i]), targets[i], failed);
    if (failed)
      throw InputError(fmt::format("{}: cannot be put in its place, so that only {} of {} files are the new ones: {}",
                                   (fs::path(folder_) / names_[i]).string(), i, names_.size(), failed.message()));
  }
  std::set<fs::path> folders;
  for (const fs::path& target : targets)
    if (folders.insert(target.parent_path()).second) syncFolder(target);
}

}  // namespace loomlight
