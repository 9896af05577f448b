#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/display/display_driver.h"
#include "app/editor/model/view_folder.h"
#include "app/live/task_queue.h"
#include "core/fabric/model/fabric.h"
#include "ui/viewport/compare_dialog.h"
#include "ui/viewport/snapshot_strip.h"

namespace loomlight {

/// The views that a designer has kept: pictures, and the fabrics with the cameras that they show. They last from one
/// session to the next; a thread of its own reads and writes them.
class SnapshotShelf {
 public:
  /// `wake` is called from that thread when there is something to follow().
  SnapshotShelf(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake);

  /// Takes what has been read; once a frame.
  void follow();
  /// Returns what to renew() it by.
  std::string keep(std::shared_ptr<const Fabric> fabric, Pixels8 picture);
  /// With a better picture of the same, unless it has been removed meanwhile.
  void renew(const std::string& id, Pixels8 picture);
  void remove(size_t index);
  /// Also while the first are still being read.
  bool empty() const { return kept_.empty() && awaited_ == 0; }
  /// Why the newest view will not last; empty while all is well.
  std::string problem() const;
  const Fabric& fabric(size_t index) const { return *kept_[index].view.fabric; }
  std::vector<SnapshotItem> items() const;

  void compare(size_t first, size_t second);
  /// Of the pair last compared.
  CompareDialog::Model comparison() const;

 private:
  struct Kept {
    std::string name;
    KeptView view;
    std::shared_ptr<PictureTexture> texture;
  };
  /// What the thread has brought.
  struct Brought {
    std::mutex mutex;
    std::vector<KeptView> views;
    size_t unreadable = 0;
    std::string problem;
  };
  void add(KeptView view);
  void readLater(const std::string& id);
  void writeLater(KeptView view);

  static constexpr ViewFolder::Budget kBudget{};
  ViewFolder folder_;
  DisplayDriver& driver_;
  std::function<void()> wake_;
  std::vector<Kept> kept_;
  std::vector<Kept> compared_;
  std::unique_ptr<PictureTexture> difference_;
  int count_ = 0;
  size_t awaited_ = 0;  ///< views that are still being read
  mutable Brought brought_;
  TaskQueue disk_;  // last: it ends before what its tasks use is gone
};

}  // namespace loomlight
