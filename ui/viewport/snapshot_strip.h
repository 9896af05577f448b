#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/widgets/ui.h"

namespace loomlight {

/// A view of the cloth that was kept, as the strip shows it.
struct SnapshotItem {
  ImTextureID picture{};
  float aspect = 1;  ///< width over height
  std::string name;
};

/// Which of the kept views are chosen, the newest choice last; at most two.
struct SnapshotStripView {
  std::vector<int> chosen;
};

struct SnapshotStripEdit {
  bool keep = false;           ///< the present view
  std::optional<int> restore;  ///< its fabric and camera
  std::optional<int> remove;
  std::optional<std::pair<int, int>> compare;
};

/// Height of the strip at scale 1.
inline constexpr float kSnapshotStripHeight = 92;

/// The kept views side by side. A click chooses, a double click restores.
SnapshotStripEdit snapshotStrip(Ui& ui, const std::vector<SnapshotItem>& items, SnapshotStripView& view);

}  // namespace loomlight
