#pragma once

#include "core/fabric/model/fabric.h"
#include "ui/inspector/inspector.h"

namespace loomlight {

/// Reed and selvedges as the mill writes them, and the setts of the cloth from the reed to the wash, side by side. True
/// when the fabric's mill data changed.
bool millRows(Ui& ui, Fabric& fabric, const InspectorModel& model);

}  // namespace loomlight
