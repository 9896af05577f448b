#pragma once

#include <string>

#include "ui/widgets/widget_probe.h"

namespace loomlight {

/// Writes what the probe saw to a file whenever it has changed: {"widgets": {name: [x0, y0, x1, y1]}, "facts": {...}}.
/// The file is replaced as a whole, so a reader never sees half of it. For tests and debugging.
class WidgetDump {
 public:
  explicit WidgetDump(std::string file) : file_(std::move(file)) {}
  void write(const WidgetProbe::Snapshot& snapshot);

 private:
  std::string file_;
  WidgetProbe::Snapshot written_;
};

}  // namespace loomlight
