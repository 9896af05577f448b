#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/live/colour_worker.h"
#include "ui/inspector/cloth_colour.h"

namespace loomlight {

/// Stands between the page of fibres and the worker that finds colours: asks while the page is open, and hands on the
/// edit that a wanted colour comes to.
class ClothColourService {
 public:
  explicit ClothColourService(std::function<void()> wake) : worker_(std::move(wake)) {}

  /// `what`: a fibre, or kPiece.
  ClothColourModel model(const Fabric& fabric, int what, const ClothColourView& view) const;
  /// Asks for what the page wants to know. The fabric after an edit, once an answer to a wanted colour is there: each
  /// is handed out once, and only while what it dyes is looked at.
  std::optional<Fabric> follow(const std::shared_ptr<const Fabric>& fabric, int what, const ClothColourView& view);

 private:
  ColourWorker worker_;
  std::shared_ptr<const Fabric> askedFabric_;
  int asked_ = 0;
  uint64_t askedWish_ = 0, doneWish_ = 0;
};

}  // namespace loomlight
