#pragma once

#include <functional>
#include <memory>

#include "app/live/worker.h"
#include "core/fabric/model/fabric.h"
#include "ui/dialogs/tile_size_rows.h"

namespace loomlight {

/// How large the seamless tile of a fabric is. A large repeat takes longer than a frame to look through.
class TileSizeService {
 public:
  /// `wake` is called from the worker.
  explicit TileSizeService(std::function<void()> wake);

  /// Of this fabric from now on.
  void ask(const std::shared_ptr<const Fabric>& fabric);
  TileModel newest() const { return worker_.newest().value_or(TileModel{}); }

 private:
  Worker<std::shared_ptr<const Fabric>, TileModel> worker_;
};

}  // namespace loomlight
