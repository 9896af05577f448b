#include "app/editor/autosave.h"

#include <fmt/core.h>
#include <signal.h>
#include <unistd.h>

#include <charconv>
#include <condition_variable>

#include "core/base/error.h"
#include "core/fabric/fabric_json.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "autosave-", kSuffix = ".json";
constexpr std::chrono::seconds kBetweenWrites{2};

/// The process that wrote a copy; nullopt when the file is none.
std::optional<pid_t> writerOf(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return std::nullopt;
  pid_t pid = 0;
  const char* begin = name.data() + kPrefix.size();
  const char* end = name.data() + name.size() - kSuffix.size();
  const auto [at, error] = std::from_chars(begin, end, pid);
  if (error != std::errc() || at != end || pid <= 0) return std::nullopt;
  return pid;
}

bool isRunning(pid_t pid) {
  return kill(pid, 0) == 0 || errno == EPERM;
}

}  // namespace

Autosave::Autosave(fs::path folder, std::function<void()> wake) : wake_(std::move(wake)) {
  std::error_code ignored;  // without the folder the first write fails, and says so
  fs::create_directories(folder, ignored);
  file_ = folder / fmt::format("{}{}{}", kPrefix, getpid(), kSuffix);
  thread_ = std::jthread([this](std::stop_token stop) { loop(stop); });
}

Autosave::~Autosave() = default;

void Autosave::endWell() {
  thread_.request_stop();
  thread_.join();
  std::error_code ignored;
  fs::remove(file_, ignored);
  removeTakenOver();
}

void Autosave::keep(std::shared_ptr<const Fabric> fabric) {
  work_.post(std::move(fabric));
}

void Autosave::forget() {
  work_.post(nullptr);
}

void Autosave::takeOver(fs::path left) {
  const std::lock_guard lock(mutex_);
  takenOver_ = std::move(left);
}

std::string Autosave::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void Autosave::setProblem(std::string problem) {
  {
    const std::lock_guard lock(mutex_);
    if (problem == problem_) return;
    problem_ = std::move(problem);
  }
  if (wake_) wake_();
}

void Autosave::removeTakenOver() {
  fs::path old;
  {
    const std::lock_guard lock(mutex_);
    old.swap(takenOver_);
  }
  std::error_code ignored;
  if (!old.empty()) fs::remove(old, ignored);
}

void Autosave::write(const Fabric& fabric) {
  try {
    writeFabric(fabric, file_.string());
    removeTakenOver();
    setProblem({});
  } catch (const std::exception& error) {
    // A full disk must not stop the designer from working, who is told.
    setProblem(error.what());
  }
}

void Autosave::loop(std::stop_token stop) {
  std::mutex mutex;
  std::condition_variable_any pause;
  while (auto work = work_.wait(stop)) {
    if (!*work) {
      std::error_code ignored;
      fs::remove(file_, ignored);
      setProblem({});
      continue;
    }
    write(**work);
    std::unique_lock lock(mutex);
    pause.wait_for(lock, stop, kBetweenWrites, [] { return false; });
  }
}

std::optional<fs::path> Autosave::leftBehind(const fs::path& folder) {
  std::optional<fs::path> newest;
  fs::file_time_type newestTime;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::optional<pid_t> writer = writerOf(it->path());
    if (!writer || isRunning(*writer)) continue;
    std::error_code unreadable;
    const fs::file_time_type time = it->last_write_time(unreadable);
    if (unreadable || (newest && time <= newestTime)) continue;
    newest = it->path();
    newestTime = time;
  }
  return newest;
}

}  // namespace loomlight
