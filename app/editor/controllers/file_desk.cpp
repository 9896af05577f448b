#include "app/editor/controllers/file_desk.h"

#include <exception>
#include <new>
#include <utility>

#include "app/export/file_name.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {
namespace {

/// Nothing leaves the thread but in the result.
template <class Task>
void attempt(const Task& task, FileDesk::Result& result) {
  try {
    task(result);
  } catch (const std::bad_alloc&) {
    result.problem = result.file + ": needs more memory than there is";
  } catch (const std::exception& error) {
    result.problem = error.what();
  }
}

FileDesk::Result about(FileDesk::Work work, std::string file, uint64_t state) {
  FileDesk::Result result;
  result.work = work;
  result.file = std::move(file);
  result.state = state;
  return result;
}

}  // namespace

FileDesk::FileDesk(std::function<void()> wake, Read read)
    : wake_(std::move(wake)), read_(std::move(read)), reads_(wake_) {}

WifImport FileDesk::readCloth(const std::string& file, const Fabric& mine) {
  return isWeavingFile(file) ? readWifFabric(file, mine, WifSizeChoice::keep) : WifImport{readFabric(file), {}};
}

void FileDesk::open(Work work, std::string file, std::shared_ptr<const Fabric> mine, uint64_t state) {
  stop_ = std::stop_source();
  busy_ = Busy{work, file};
  reads_.ask([result = about(work, std::move(file), state), mine = std::move(mine), read = read_](const auto&) mutable {
    attempt(
        [&](Result& to) {
          WifImport cloth = read(to.file, *mine);
          to.fabric = std::move(cloth.fabric);
          to.warnings = std::move(cloth.warnings);
        },
        result);
    return std::move(result);
  });
}

void FileDesk::write(Result about, Task task) {
  stop_ = std::stop_source();
  busy_ = Busy{about.work, about.file};
  writes_.post([this, result = std::move(about), task = std::move(task), stop = stop_.get_token()]() mutable {
    result.cancelled = stop.stop_requested();
    if (!result.cancelled) attempt([&](Result& to) { task(stop, to); }, result);
    written_.post(std::move(result));
    wake_();
  });
}

void FileDesk::save(std::string file, std::shared_ptr<const Fabric> fabric, uint64_t state) {
  write(about(Work::save, std::move(file), state),
        [fabric = std::move(fabric)](const std::stop_token& stop, Result& result) {
          result.cancelled = !writeFabric(*fabric, result.file, stop);
        });
}

void FileDesk::exportTo(std::string file, std::function<std::vector<std::string>()> write) {
  this->write(about(Work::exportTo, std::move(file), 0),
              [write = std::move(write)](const std::stop_token&, Result& result) { result.remarks = write(); });
}

void FileDesk::cancel() {
  stop_.request_stop();
  if (!isReading()) return;
  reads_.forget();
  busy_.reset();
}

std::optional<FileDesk::Result> FileDesk::take() {
  auto come = reads_.take();
  if (!come) come = written_.take();
  if (come) busy_.reset();
  return come;
}

}  // namespace loomlight
