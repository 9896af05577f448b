#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/colour/tone.h"
#include "render/film/image.h"

namespace loomlight {

/// How a snapshot is printed.
struct SnapshotPrint {
  std::function<Pixels8(Pixels8)> finish;  ///< makes of a .png's pixels what is written; empty: these themselves
  double dpi = 0;                          ///< its size on paper; 0: none
};

/// Renders a fabric's own RenderSettings to a file: .exr with AOVs and metadata, or .png. Returns false, and writes
/// nothing, when stopped. Throws InputError.
bool writeSnapshot(const std::shared_ptr<const Fabric>& fabric, const std::string& file, const Tone& tone,
                   const SnapshotPrint& print, const Task& task);

}  // namespace loomlight
