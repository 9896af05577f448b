#pragma once

#include "app/editor/services/fabric_stats.h"
#include "app/live/live_renderer.h"
#include "app/live/visibility_worker.h"
#include "ui/status_bar.h"

namespace loomlight {

/// What the status bar says of the cloth and its picture. `stats` and `shown` (the picture on the screen) may be
/// null.
StatusModel statusModel(const FabricStats* stats, const LiveStatus& status, const VisibilityWorker::Status& baking,
                        const Frame* shown);

}  // namespace loomlight
