#pragma once

#include <optional>
#include <string>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

inline constexpr double kPrintSide_mm[] = {1, 2000}, kPrintResolution_dpi[] = {30, 2400};

/// How much cloth a snapshot shows.
enum class SnapshotScale {
  asSeen,
  actualSize,  ///< a millimetre of cloth is one of paper
  wholePiece   ///< of cloth that lies flat, and nothing beside it
};

/// How large a snapshot is to be, and what stands below it.
struct SnapshotOptions {
  bool inMillimetres = false;  ///< for print; else in pixels
  double width_mm = 120, height_mm = 90, dpi = 300;
  SnapshotScale scale = SnapshotScale::asSeen;
  bool scaleBar = false;
  std::string caption;
};

/// Pixels of a printed length, at least 1 and at most what a picture may have.
int pixelsOfPrint(double length_mm, double dpi);

/// What of the cloth there is to be seen.
struct ClothInView {
  double height_mm = 0;                  ///< that the camera sees, from top to bottom
  std::optional<glm::dvec2> piece_mm{};  ///< of cloth that lies flat: width and height
};

/// Their rows. True when the number of pixels changed.
bool snapshotOptionRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings, const ClothInView& seen);

}  // namespace loomlight
