#include "ui/viewport/snapshot_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/member_fields.h"

namespace loomlight {
namespace {

constexpr double kMmPerInch = 25.4;

bool lengthField(Ui& ui, const char* id, const char* label, double& length_mm) {
  NumberStyle style;
  style.unit = "mm";
  style.min = kPrintSide_mm[0];
  style.max = kPrintSide_mm[1];
  style.decimals = 1;
  style.logarithmic = true;
  return numberField(ui, {id, label, "On paper"}, style, length_mm);
}

/// Width, height and resolution of the print; the pixels follow.
bool printRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings) {
  lengthField(ui, "snapshot.width_mm", "Width", options.width_mm);
  lengthField(ui, "snapshot.height_mm", "Height", options.height_mm);
  NumberStyle style;
  style.unit = "dpi";
  style.min = kPrintResolution_dpi[0];
  style.max = kPrintResolution_dpi[1];
  style.decimals = 0;
  style.logarithmic = true;
  numberField(ui, {"snapshot.dpi", "Resolution", "Pixels on an inch of paper: 300 for print, 150 for a large poster"},
              style, options.dpi);
  readout(ui, {"snapshot.pixels", "Pixels", "Of the picture"},
          fmt::format("{} \xC3\x97 {}", settings.width, settings.height));
  const int width = pixelsOfPrint(options.width_mm, options.dpi);
  const int height = pixelsOfPrint(options.height_mm, options.dpi);
  if (width == settings.width && height == settings.height) return false;
  settings.width = width;
  settings.height = height;
  return true;
}

}  // namespace

int pixelsOfPrint(double length_mm, double dpi) {
  const FieldInfo info = fieldInfo(&RenderSettings::width);
  return static_cast<int>(std::lround(std::clamp(length_mm / kMmPerInch * dpi, info.min, info.max)));
}

bool snapshotOptionRows(Ui& ui, SnapshotOptions& options, RenderSettings& settings) {
  static constexpr const char* kUnits[] = {"Pixels", "Print, mm"};
  int unit = options.inMillimetres ? 1 : 0;
  if (segmentField(ui, {"snapshot.size_in", "Size in", "For a screen, or for a print of a size."}, kUnits, unit) &&
      unit == 1) {
    options.width_mm = settings.width / options.dpi * kMmPerInch;
    options.height_mm = settings.height / options.dpi * kMmPerInch;
  }
  options.inMillimetres = unit == 1;
  bool changed = false;
  if (options.inMillimetres) {
    changed = printRows(ui, options, settings);
  } else {
    changed |= memberField(ui, "snapshot", settings, &RenderSettings::width);
    changed |= memberField(ui, "snapshot", settings, &RenderSettings::height);
  }
  switchField(ui,
              {"snapshot.scale_bar", "Scale bar",
               "A bar of a round length below the picture, right where the camera looks; .png only."},
              options.scaleBar);
  textField(ui, {"snapshot.caption", "Caption", "Stands below the picture; .png only. Empty: none."}, options.caption);
  return changed;
}

}  // namespace loomlight
