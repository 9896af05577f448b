#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/export/handover/digital_cloth.h"

namespace loomlight {

struct HandoverReport {
  std::vector<std::string> files;  ///< that were written, within the folder
  std::vector<std::string> lines;  ///< for people: the fit of either side and its error, and what is experimental
  /// RMS over directions of what is fitted to the front and the back less what was measured, per cent of its mean.
  double front_percent = 0, back_percent = 0;
};

/// The files that a hand-over of this name writes, within its folder.
std::vector<std::string> handoverFiles(const std::string& name);

/// Writes a cloth in the formats of other programs into a folder, which is there:
/// - textures/NAME_BASE.png and its like, and those of the back as textures/NAME_back_BASE.png, for drag and drop;
/// - NAME.u3m, which refers to them, and NAME.u3ma, which holds both;
/// - NAME.glb and NAME_back.glb: a swatch of either side, with all that it takes;
/// - NAME.mtlx and NAME_back.mtlx (MaterialX, OpenPBR), which refer to the textures;
/// - NAME.jfab, for CLO: tried by nobody who has the program;
/// - NAME.handover.json: sizes, mass, thickness, parameters, errors of the fit, encodings.
/// `name`: a file's. They are put in their places together (FileSet). Nothing when stopped: none is there then. Throws
/// InputError.
std::optional<HandoverReport> writeHandover(const std::string& folder, const std::string& name,
                                            const DigitalCloth& cloth, std::chrono::sys_seconds now, const Task& task);

}  // namespace loomlight
