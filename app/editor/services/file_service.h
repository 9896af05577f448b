#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {

/// Reads and writes files, but not in the thread of the window: a large jacquard takes a second, and a slow disk more.
/// One at a time; what is asked for is said in busy() until its result is taken, or it is cancelled.
///
/// The destructor waits for what was to be written. A read that was cancelled goes on unseen, and holds up nothing.
class FileService {
 public:
  enum class Work { open, takeUp, usePreset, save, exportTo, renderTo };
  /// Whether it reads a file; the others write one.
  static bool reads(Work work) { return work == Work::open || work == Work::takeUp || work == Work::usePreset; }

  /// Reads a cloth, a weaving file with `mine`, and throws InputError.
  using Read = std::function<WifImport(const std::string& file, const Fabric& mine)>;
  static WifImport readCloth(const std::string& file, const Fabric& mine);

  /// `wake` is called from other threads when there is something to take().
  explicit FileService(std::function<void()> wake, Read read = readCloth);

  /// A fabric, or by the name's ending a weaving file, which takes from `mine` what it does not say. `state` of the
  /// document comes back with the result, here and in save().
  void open(Work work, std::string file, std::shared_ptr<const Fabric> mine, uint64_t state);
  void save(std::string file, std::shared_ptr<const Fabric> fabric, uint64_t state);
  /// `write` throws, or returns what there is to say of the file that it has written.
  void exportTo(std::string file, std::function<std::vector<std::string>()> write);
  /// The same of what takes a while, may say how far it is, and can be cancelled: then `write` returns false and leaves
  /// no file.
  void renderTo(std::string file, std::function<bool(const Task&)> write);

  struct Busy {
    Work work;
    std::string file;
  };
  const std::optional<Busy>& busy() const { return busy_; }
  bool isReading() const { return busy_ && reads(busy_->work); }
  /// How much is done of what is rendered to a file, 0 to 1, once that says so.
  std::optional<double> fraction() const;
  /// An export cannot be cancelled; anything else can be, once.
  bool canCancel() const { return busy_ && busy_->work != Work::exportTo && !cancelled_; }
  /// Nothing will come of what was to be read. What was to be saved will say how far it came.
  void cancel();

  struct Result {
    Work work = Work::open;
    std::string file;
    std::optional<Fabric> fabric;      ///< that was read
    std::vector<WifWarning> warnings;  ///< about the file that was read
    WifNamed named;                    ///< of its threads: see cutToNamed()
    std::vector<std::string> remarks;  ///< about what was written
    std::string problem;               ///< why it was not; empty when all went well
    bool cancelled = false;            ///< and the file is as it was
    uint64_t state = 0;
  };
  /// Once.
  std::optional<Result> take();

 private:
  struct ReadOrder {
    Result about;
    std::shared_ptr<const Fabric> mine;
  };
  struct WriteOrder {
    Result about;
    std::function<void(const std::stop_token&, Result&)> write;
  };
  void begin(const Result& about);

  std::optional<Busy> busy_;
  bool cancelled_ = false;            ///< what is busy_
  std::atomic<double> fraction_ = 0;  ///< of what is busy_; told by the thread that writes
  Worker<ReadOrder, Result> reads_;
  Worker<WriteOrder, Result> writes_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
