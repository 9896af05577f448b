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

  /// `part`: that is looked at.
  ClothColourModel model(const std::shared_ptr<const Fabric>& fabric, const ClothPart& part,
                         const ClothColourView& view) const;
  /// Asks for what the page wants to know. The fabric after an edit, once an answer to a wanted colour is there: each
  /// is handed out once, and only while what it dyes is looked at and still wanted.
  std::optional<Fabric> follow(const std::shared_ptr<const Fabric>& fabric, const ClothPart& part,
                               const ClothColourView& view);
  /// What is known of the cloth so far says nothing of the next one.
  void forget() { forgotten_ = worker_.newest(); }

 private:
  ColourWorker worker_;
  std::shared_ptr<const ColourAnswer> forgotten_;
  std::shared_ptr<const Fabric> askedFabric_;
  ClothPart asked_;
  uint64_t askedWish_ = 0, doneWish_ = 0;
};

}  // namespace loomlight
