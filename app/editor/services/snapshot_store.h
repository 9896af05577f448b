#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/display/display_driver.h"
#include "app/editor/model/view_folder.h"
#include "app/live/worker.h"
#include "core/fabric/model/fabric.h"
#include "ui/viewport/compare_dialog.h"
#include "ui/viewport/snapshot_strip.h"

namespace loomlight {

/// The views that a designer has kept: pictures, and the fabrics with the cameras that they show. They last from one
/// session to the next; a thread of its own reads and writes them.
class SnapshotStore {
 public:
  /// `wake` is called from that thread when there is something to follow().
  SnapshotStore(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake,
                ViewFolder::Budget budget = {});
  /// Tries the views that are on no disk once more.
  ~SnapshotStore() { keepAgain(); }
  SnapshotStore(const SnapshotStore&) = delete;
  SnapshotStore& operator=(const SnapshotStore&) = delete;

  /// Takes what has been read; once a frame.
  void follow();
  /// Returns what to renew() it by.
  std::string keep(std::shared_ptr<const Fabric> fabric, const ClothView& view, Pixels8 picture);
  /// With a better picture of the same, unless it has been removed meanwhile.
  void renew(const std::string& id, Pixels8 picture);
  void remove(const std::string& id);
  /// Also while the first are still being read.
  bool empty() const { return kept_.empty() && awaited_ == 0; }
  /// Why a view will not last, the newest of them; empty while all do.
  std::string problem() const { return unkept_.empty() ? "" : unkept_.rbegin()->second; }
  const KeptView& view(const std::string& id) const { return find(id)->view; }
  std::vector<SnapshotItem> items() const;

  void compare(const std::string& first, const std::string& second);
  /// Of the pair last compared.
  CompareDialog::Model comparison() const;

 private:
  struct Kept {
    std::string name;
    KeptView view;
    std::shared_ptr<PictureTexture> texture;
  };
  struct Order {
    enum class Work { read, keep, keepAgain, remove } work;
    KeptView view;  ///< to read and to remove: its name alone
  };
  struct Done {
    Order::Work work;
    std::string id;
    std::optional<KeptView> view;      ///< that was read
    std::vector<std::string> removed;  ///< views that there was no more room for
    std::string problem;
  };
  static Done done(const ViewFolder& folder, const Order& order);
  void add(KeptView view);
  void keepAgain();
  void drop(const std::string& id);
  std::vector<Kept>::const_iterator find(const std::string& id) const;

  const ViewFolder::Budget budget_;
  ViewFolder folder_;
  DisplayDriver& driver_;
  std::vector<Kept> kept_;
  std::vector<Kept> compared_;
  std::unique_ptr<PictureTexture> difference_;
  int count_ = 0;
  size_t awaited_ = 0;                         ///< views that are still being read
  std::map<std::string, std::string> unkept_;  ///< views that are not on the disk as they are here, and why
  Worker<Order, Done> disk_;                   // last: it ends before what it uses is gone
};

}  // namespace loomlight
