#include "ui/viewport/snapshot_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/units.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/picture_words.h"

namespace loomlight {
namespace {

bool lengthField(Ui& ui, const char* id, const Word& word, double& length_mm) {
  NumberStyle style;
  style.unit = "mm";
  style.min = kPrintSide_mm[0];
  style.max = kPrintSide_mm[1];
  style.decimals = 1;
  style.logarithmic = true;
  return numberField(ui, {id, word}, style, length_mm);
}

void resolutionField(Ui& ui, double& dpi) {
  NumberStyle style;
  style.unit = "dpi";
  style.min = kPrintResolution_dpi[0];
  style.max = kPrintResolution_dpi[1];
  style.decimals = 0;
  style.logarithmic = true;
  numberField(ui, {"snapshot.dpi", words::snapshot::resolution}, style, dpi);
}

/// Width, height and resolution of the print; the pixels follow.
bool printRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings) {
  lengthField(ui, "snapshot.width_mm", words::snapshot::width, options.width_mm);
  lengthField(ui, "snapshot.height_mm", words::snapshot::height, options.height_mm);
  resolutionField(ui, options.dpi);
  const int width = pixelsOfPrint(options.width_mm, options.dpi);
  const int height = pixelsOfPrint(options.height_mm, options.dpi);
  const bool changed = width != settings.width || height != settings.height;
  settings.width = width;
  settings.height = height;
  readout(ui, {"snapshot.pixels", words::snapshot::pixels}, fmt::format("{} \xC3\x97 {}", width, height));
  return changed;
}

/// Width and height in pixels; the size on paper follows. As many rows as for a print, so that a change of units moves
/// nothing under the mouse.
bool pixelRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings) {
  bool changed = memberField(ui, "snapshot", settings, &RenderSettings::width);
  changed |= memberField(ui, "snapshot", settings, &RenderSettings::height);
  resolutionField(ui, options.dpi);
  const auto length_mm = [&](int pixels) { return pixels / options.dpi * kMmPerInch; };
  readout(ui, {"snapshot.paper", words::snapshot::paper},
          fmt::format("{:.0f} \xC3\x97 {:.0f} mm", length_mm(settings.width), length_mm(settings.height)));
  return changed;
}

/// How much cloth there is to be seen, which is another thing than how large the paper is.
void clothRows(Ui& ui, SnapshotOptions& options, const RenderSettings& settings, const ClothInView& seen) {
  if (!seen.piece_mm && options.scale == SnapshotScale::wholePiece) options.scale = SnapshotScale::asSeen;
  const std::span<const char* const> scales = words::snapshot::scales;
  segmentField(ui, {"snapshot.scale", words::snapshot::scale}, scales.first(seen.piece_mm ? 3 : 2), options.scale);
  const double paper_mm = settings.height / options.dpi * kMmPerInch;
  const double height_mm = options.scale == SnapshotScale::actualSize   ? paper_mm
                           : options.scale == SnapshotScale::wholePiece ? seen.piece_mm->y
                                                                        : seen.height_mm;
  readout(ui, {"snapshot.cloth", words::snapshot::cloth},
          fmt::format("{:.1f} \xC3\x97 {:.1f} mm", height_mm * settings.width / settings.height, height_mm));
}

/// The height follows the width, in the proportions of the piece.
bool inProportion(SnapshotOptions& options, RenderSettings& settings, const glm::dvec2& piece_mm) {
  const FieldInfo pixels = fieldInfo(&RenderSettings::height);
  const double ratio = piece_mm.y / piece_mm.x;
  options.height_mm = std::clamp(options.width_mm * ratio, kPrintSide_mm[0], kPrintSide_mm[1]);
  const int height = options.inMillimetres
                         ? pixelsOfPrint(options.height_mm, options.dpi)
                         : static_cast<int>(std::lround(std::clamp(settings.width * ratio, pixels.min, pixels.max)));
  return std::exchange(settings.height, height) != height;
}

}  // namespace

int pixelsOfPrint(double length_mm, double dpi) {
  const FieldInfo info = fieldInfo(&RenderSettings::width);
  return static_cast<int>(std::lround(std::clamp(length_mm / kMmPerInch * dpi, info.min, info.max)));
}

bool snapshotOptionRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings, const ClothInView& seen) {
  const bool isOther = segmentField(ui, {"snapshot.size_in", words::snapshot::sizeIn}, words::snapshot::sizeUnits,
                                    options.inMillimetres);
  if (isOther && options.inMillimetres) {
    options.width_mm = settings.width / options.dpi * kMmPerInch;
    options.height_mm = settings.height / options.dpi * kMmPerInch;
  }
  bool changed = options.inMillimetres ? printRows(ui, options, settings) : pixelRows(ui, options, settings);
  clothRows(ui, options, settings, seen);
  if (options.scale == SnapshotScale::wholePiece) changed |= inProportion(options, settings, *seen.piece_mm);
  switchField(ui, {"snapshot.scale_bar", words::snapshot::scaleBar}, options.scaleBar);
  textField(ui, {"snapshot.caption", words::snapshot::caption}, options.caption);
  return changed;
}

}  // namespace loomlight
