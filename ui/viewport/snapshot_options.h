#pragma once

#include <string>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

inline constexpr double kPrintSide_mm[] = {1, 2000}, kPrintResolution_dpi[] = {30, 2400};

/// How large a snapshot is to be, and what stands below it.
struct SnapshotOptions {
  bool inMillimetres = false;  ///< for print; else in pixels
  double width_mm = 120, height_mm = 90, dpi = 300;
  bool actualSize = false;  ///< a millimetre of cloth is one of paper
  bool scaleBar = false;
  std::string caption;
};

/// Pixels of a printed length, at least 1 and at most what a picture may have.
int pixelsOfPrint(double length_mm, double dpi);

/// Their rows. `seen_mm`: how much cloth the camera sees, from top to bottom. True when the number of pixels changed.
bool snapshotOptionRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings, double seen_mm);

}  // namespace loomlight
