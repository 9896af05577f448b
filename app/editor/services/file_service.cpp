#include "app/editor/services/file_service.h"

#include <utility>

#include "app/export/file_name.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {
namespace {

FileService::Result about(FileService::Work work, std::string file, uint64_t state) {
  FileService::Result result;
  result.work = work;
  result.file = std::move(file);
  result.state = state;
  return result;
}

/// In the place of a result. Not every problem names its file.
template <class Order>
FileService::Result failed(const Order& order, const std::string& problem) {
  FileService::Result result = order.about;
  result.problem = problem.find(result.file) == std::string::npos ? result.file + ": " + problem : problem;
  return result;
}

}  // namespace

FileService::FileService(std::function<void()> wake, Read read)
    : reads_(
          wake,
          [read = std::move(read)](const ReadOrder& order, const auto&) {
            Result result = order.about;
            WifImport cloth = read(result.file, *order.mine);
            result.fabric = std::move(cloth.fabric);
            result.warnings = std::move(cloth.warnings);
            result.named = cloth.named;
            return result;
          },
          failed<ReadOrder>, Backlog::hanging),
      writes_(
          std::move(wake),
          [](const WriteOrder& order, const auto& job) {
            Result result = order.about;
            result.cancelled = job.isStopped();
            if (!result.cancelled) order.write(job.stop(), result);
            return result;
          },
          failed<WriteOrder>, Backlog::every, Priority::picture) {}  // it is waited for, and renders

WifImport FileService::readCloth(const std::string& file, const Fabric& mine) {
  if (isWeavingFile(file)) return readWifFabric(file, mine, WifSizeChoice::keep);
  FabricReading reading = openFabric(file);
  WifImport cloth{std::move(reading.fabric), {}};
  for (std::string& remark : reading.remarks) cloth.warnings.push_back({std::move(remark), {}});
  return cloth;
}

void FileService::begin(const Result& about) {
  busy_ = Busy{about.work, about.file};
  cancelled_ = false;
  fraction_ = 0;
}

void FileService::open(Work work, std::string file, std::shared_ptr<const Fabric> mine, uint64_t state) {
  ReadOrder order{about(work, std::move(file), state), std::move(mine)};
  begin(order.about);
  reads_.ask(std::move(order));
}

void FileService::save(std::string file, std::shared_ptr<const Fabric> fabric, uint64_t state) {
  WriteOrder order{about(Work::save, std::move(file), state),
                   [fabric = std::move(fabric)](const std::stop_token& stop, Result& result) {
                     result.cancelled = !writeFabric(*fabric, result.file, stop);
                   }};
  begin(order.about);
  writes_.ask(std::move(order));
}

void FileService::exportTo(std::string file, std::function<std::vector<std::string>()> write) {
  WriteOrder order{about(Work::exportTo, std::move(file), 0),
                   [write = std::move(write)](const std::stop_token&, Result& result) { result.remarks = write(); }};
  begin(order.about);
  writes_.ask(std::move(order));
}

void FileService::renderTo(std::string file, std::function<bool(const Task&)> write) {
  WriteOrder order{about(Work::renderTo, std::move(file), 0),
                   [this, write = std::move(write)](const std::stop_token& stop, Result& result) {
                     Task task;
                     task.stop = stop;
                     task.progress = [this](double fraction) { fraction_ = fraction; };
                     result.cancelled = !write(task);
                   }};
  begin(order.about);
  writes_.ask(std::move(order));
}

std::optional<double> FileService::fraction() const {
  const double done = busy_ && busy_->work == Work::renderTo ? fraction_.load() : 0;
  return done > 0 ? std::optional(done) : std::nullopt;
}

void FileService::cancel() {
  if (!canCancel()) return;
  cancelled_ = true;
  if (!isReading()) return writes_.cancel();
  reads_.forget();
  busy_.reset();
}

std::optional<FileService::Result> FileService::take() {
  auto come = reads_.take();
  if (!come) come = writes_.take();
  if (come) busy_.reset();
  return come;
}

}  // namespace loomlight
