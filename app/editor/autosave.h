#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "app/workers/mailbox.h"
#include "core/fabric/fabric.h"

namespace loomlight {

/// Keeps a copy of unsaved work on disk, written by a thread of its own a moment after each edit. The copy is removed
/// when the editor ends well, so one that is there belongs to an editor that did not.
class Autosave {
 public:
  /// Every running editor has a file of its own in `folder`, named after its process.
  explicit Autosave(std::filesystem::path folder);
  ~Autosave();  ///< removes the copy

  void keep(std::shared_ptr<const Fabric> fabric);
  void forget();  ///< the work is saved: removes the copy

  /// The newest copy left in the folder by an editor that is no longer running.
  static std::optional<std::filesystem::path> leftBehind(const std::filesystem::path& folder);

 private:
  void loop(std::stop_token stop);

  std::filesystem::path file_;
  Mailbox<std::shared_ptr<const Fabric>> work_;
  std::jthread thread_;
};

}  // namespace loomlight
