#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/picture_texture.h"
#include "core/fabric/fabric.h"
#include "ui/compare_dialog.h"
#include "ui/snapshot_strip.h"

namespace loomlight {

/// The views that a designer has kept in this session: pictures, and the fabrics with the cameras that they show.
class SnapshotShelf {
 public:
  static constexpr size_t kMost = 32;  ///< then the oldest go

  void keep(std::shared_ptr<const Fabric> fabric, Pixels8 picture);
  void remove(size_t index);
  bool empty() const { return kept_.empty(); }
  const Fabric& fabric(size_t index) const { return *kept_[index].fabric; }
  std::vector<SnapshotItem> items() const;

  void compare(size_t first, size_t second);
  /// Of the pair last compared.
  CompareDialog::Model comparison() const;

 private:
  struct Kept {
    std::string name;
    std::shared_ptr<const Fabric> fabric;
    Pixels8 picture;
    std::shared_ptr<PictureTexture> texture;
  };
  std::vector<Kept> kept_;
  std::vector<Kept> compared_;
  PictureTexture difference_;
  int count_ = 0;
};

}  // namespace loomlight
