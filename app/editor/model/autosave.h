#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/live/worker.h"
#include "core/base/file_lock.h"
#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Keeps a copy of unsaved work on disk, written by a thread of its own a moment after each edit. The copy is removed
/// when the editor ends well, so one that is there belongs to an editor that did not.
///
/// Every editor has a file in `folder` whose name nobody else will ever have, and beside it another that it keeps
/// locked while it runs: a number of a process would come again, and after a restart of the machine stand for another.
class Autosave {
 public:
  /// `wake` is called from the thread when problem() changes.
  explicit Autosave(const std::filesystem::path& folder, std::function<void()> wake = {});
  ~Autosave();  ///< leaves the copy: whoever is torn down by an error still has it

  void keep(std::shared_ptr<const Fabric> fabric) { ask(std::move(fabric)); }
  void forget() { ask(nullptr); }  ///< the work is saved: removes the copy
  void endWell();                  ///< the editor ends, and nothing is to be taken up again: removes the copy, for good
  /// Removes a copy that another editor left, and what was beside it. Whatever is no copy in the folder is let alone:
  /// designers' files are never removed.
  void throwAway(const std::filesystem::path& left) const;
  /// Removes another editor's copy once the work in it has been written here: at every moment there is one copy.
  void takeOver(std::filesystem::path left) { takenOver_ = std::move(left); }
  /// Why the newest work could not be kept; empty while all is well.
  std::string problem() const;

  const std::filesystem::path& file() const { return file_; }

  /// The newest copy left in the folder by an editor that is no longer running.
  static std::optional<std::filesystem::path> leftBehind(const std::filesystem::path& folder);

 private:
  struct Work {
    std::shared_ptr<const Fabric> fabric;  ///< null: it is saved
    std::filesystem::path takenOver;       ///< goes once this is written; may be empty
  };
  using Writing = Worker<Work, std::string>;
  void ask(std::shared_ptr<const Fabric> fabric) { writing_->ask({std::move(fabric), takenOver_}); }
  void makeFolder();
  void write(const Work& work);

  std::filesystem::path file_, takenOver_;
  std::optional<FileLock> running_;  ///< none where the folder takes no files: then no copy can be kept either
  bool failed_ = false;              ///< the thread's own: the last was not written
  std::optional<Writing> writing_;   ///< brings what problem() says; last: it ends before what it uses is gone
};

}  // namespace loomlight
