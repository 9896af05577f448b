#pragma once

#include "ui/widgets/ui.h"

namespace loomlight {

/// Where the panels are. Widths in pixels at scale 1, 0 until one is dragged: it is then a share of the screen, so that
/// a larger screen has a larger draft. Kept between sessions.
struct DockLayout {
  float draftWidth = 0;
  float inspectorWidth = 0;
  bool panelsShown = true;
};

struct DockAreas {
  struct Area {
    ImVec2 min, size;
  };
  Area draft, viewport, inspector, status;
  Area strip;  ///< of snapshots, below the viewport; of no height where none is wanted
};

/// Divides the screen below the menu bar; the cloth never gets less than half of the width. `stripHeight` at scale 1.
DockAreas dockAreas(const DockLayout& layout, ImVec2 screen, float menuHeight, float scale, float stripHeight = 0);

/// The gaps between the panels, to be dragged.
void splitters(Ui& ui, DockLayout& layout, const DockAreas& areas);

/// A panel that fills its area; endPanel() closes it.
void beginPanel(const char* name, const DockAreas::Area& area, bool padded);
void endPanel();

}  // namespace loomlight
