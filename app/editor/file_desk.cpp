#include "app/editor/file_desk.h"

#include <exception>
#include <new>
#include <utility>

#include "app/workers/file_name.h"
#include "core/fabric/fabric_json.h"
#include "core/fabric/wif_fabric.h"

namespace loomlight {

FileDesk::FileDesk(std::function<void()> wake) : wake_(std::move(wake)) {}

void FileDesk::post(Work work, std::string file, uint64_t state, Task task) {
  stop_ = std::stop_source();
  busy_ = Busy{work, file};
  tasks_.post([this, work, state, file = std::move(file), task = std::move(task), stop = stop_.get_token(),
               number = ++number_] {
    Result result;
    result.work = work;
    result.file = file;
    result.state = state;
    try {
      if (stop.stop_requested())
        result.cancelled = true;
      else
        task(stop, result);
    } catch (const std::bad_alloc&) {
      result.problem = file + ": needs more memory than there is";
    } catch (const std::exception& error) {
      result.problem = error.what();
    }
    results_.post({number, std::move(result)});
    wake_();
  });
}

void FileDesk::open(Work work, std::string file, std::shared_ptr<const Fabric> mine, uint64_t state) {
  post(work, file, state, [file, mine = std::move(mine)](const std::stop_token&, Result& result) {
    if (isWeavingFile(file)) {
      WifImport import = readWifFabric(file, *mine, WifSizeChoice::keep);
      result.fabric = std::move(import.fabric);
      result.warnings = std::move(import.warnings);
    } else {
      result.fabric = readFabric(file);
    }
  });
}

void FileDesk::save(std::string file, std::shared_ptr<const Fabric> fabric, uint64_t state) {
  post(Work::save, file, state, [file, fabric = std::move(fabric)](const std::stop_token& stop, Result& result) {
    result.cancelled = !writeFabric(*fabric, file, stop);
  });
}

void FileDesk::exportTo(std::string file, std::function<std::vector<std::string>()> write) {
  post(Work::exportTo, std::move(file), 0,
       [write = std::move(write)](const std::stop_token&, Result& result) { result.remarks = write(); });
}

void FileDesk::cancel() {
  stop_.request_stop();
  if (!isReading()) return;
  ++number_;
  busy_.reset();
}

std::optional<FileDesk::Result> FileDesk::take() {
  auto come = results_.take();
  if (!come || come->first != number_) return std::nullopt;
  busy_.reset();
  return std::move(come->second);
}

}  // namespace loomlight
