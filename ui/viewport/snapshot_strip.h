#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/widgets/ui.h"

namespace loomlight {

/// A view of the cloth that was kept, as the strip shows it.
struct SnapshotItem {
  std::string id;  ///< it is known by, as the list changes
  ImTextureID picture{};
  float aspect = 1;  ///< width over height
  std::string name;
};

/// Which of the kept views are chosen, the newest choice last; at most two.
struct SnapshotStripView {
  std::vector<std::string> chosen;
};

/// By their ids.
struct SnapshotStripEdit {
  bool keep = false;                   ///< the present view
  std::optional<std::string> restore;  ///< its fabric and camera
  std::optional<std::string> remove;
  std::optional<std::pair<std::string, std::string>> compare;
};

/// Height of the strip at scale 1.
inline constexpr float kSnapshotStripHeight = 92;

/// The kept views side by side. A click chooses, a double click restores.
SnapshotStripEdit snapshotStrip(Ui& ui, const std::vector<SnapshotItem>& items, SnapshotStripView& view);

}  // namespace loomlight
