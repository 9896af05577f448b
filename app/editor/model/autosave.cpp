#include "app/editor/model/autosave.h"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "autosave-", kSuffix = ".json", kLockSuffix = ".lock";
constexpr std::chrono::seconds kBetweenWrites{2};

/// What the editor that writes a copy keeps locked.
fs::path lockOf(const fs::path& file) {
  return fs::path(file).replace_extension(kLockSuffix);
}

bool isNamed(const fs::path& file, std::string_view suffix) {
  const std::string name = file.filename().string();
  return name.starts_with(kPrefix) && name.ends_with(suffix);
}

bool isCopy(const fs::path& file) {
  return isNamed(file, kSuffix);
}

/// Removes the locks of editors that ended without a copy. Young ones stay: an editor that starts now has made its own
/// and is about to lock it.
void sweepLocks(const fs::path& folder) {
  constexpr std::chrono::minutes kYoung{1};
  std::vector<fs::path> ended;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code unknown;
    if (!isNamed(it->path(), kLockSuffix) || fs::exists(fs::path(it->path()).replace_extension(kSuffix), unknown))
      continue;
    const fs::file_time_type made = it->last_write_time(unknown);
    if (unknown || fs::file_time_type::clock::now() - made < kYoung || FileLock::isHeld(it->path())) continue;
    ended.push_back(it->path());
  }
  for (const fs::path& lock : ended) fs::remove(lock, error);
}

}  // namespace

Autosave::Autosave(const fs::path& folder, std::function<void()> wake) {
  std::error_code ignored;  // without the folder a write fails, and says so
  fs::create_directories(folder, ignored);
  sweepLocks(folder);
  const auto now_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch());
  file_ = folder / fmt::format("{}{}-{}{}", kPrefix, now_ns.count(), getpid(), kSuffix);
  running_ = FileLock::make(lockOf(file_));
  // A full disk must not stop the designer from working, who is told.
  writing_.emplace(
      std::move(wake),
      [this](const Work& work, const auto& turn) {
        write(work);
        if (std::exchange(failed_, false)) turn.bring("");
        if (work.fabric) turn.rest(kBetweenWrites);
        return std::nullopt;
      },
      [this](const Work&, const std::string& problem) {
        failed_ = true;
        return problem;
      });
}

Autosave::~Autosave() = default;

void Autosave::endWell() {
  writing_.reset();
  throwAway(file_);
  throwAway(takenOver_);
}

std::string Autosave::problem() const {
  return writing_ ? writing_->newest().value_or("") : "";
}

/// The folder may have been removed since, with the lock in it.
void Autosave::makeFolder() {
  const fs::path folder = file_.parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format(words::errors::folderNotMade, folder.string(), error.message()));
  if (!fs::exists(lockOf(file_), error)) running_ = FileLock::make(lockOf(file_));
}

void Autosave::write(const Work& work) {
  if (!work.fabric) {
    std::error_code ignored;
    fs::remove(file_, ignored);
    return;
  }
  makeFolder();
  writeFabric(*work.fabric, file_.string());
  throwAway(work.takenOver);
}

std::optional<fs::path> Autosave::leftBehind(const fs::path& folder) {
  std::optional<fs::path> newest;
  fs::file_time_type newestTime;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (!isCopy(it->path()) || FileLock::isHeld(lockOf(it->path()))) continue;
    std::error_code unreadable;
    const fs::file_time_type time = it->last_write_time(unreadable);
    if (unreadable || (newest && time <= newestTime)) continue;
    newest = it->path();
    newestTime = time;
  }
  return newest;
}

void Autosave::throwAway(const fs::path& left) const {
  if (!isCopy(left) || left.parent_path() != file_.parent_path()) return;
  std::error_code ignored;
  fs::remove(left, ignored);
  fs::remove(lockOf(left), ignored);
}

}  // namespace loomlight
