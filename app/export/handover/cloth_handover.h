#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/export/handover/handover.h"

namespace loomlight {

/// A fabric in one set of its colours, and the folder that it is handed over into.
struct HandoverPart {
  Fabric fabric;
  std::string folder;
};

/// The file that says what is in all others that a fabric is handed over as. Where there is one, they are replaced.
std::string handoverSidecar(const Fabric& fabric, const std::string& folder);

/// The fabric as it is, into `folder`; where all are wanted each of its colourways too, into a folder of its own in
/// that one, called after it. No two share a folder, nor the folder of another's textures.
std::vector<HandoverPart> handoverParts(const Fabric& fabric, const std::string& folder, bool allColourways);

/// Traces, measures, fits and writes a part, and makes its folder where there is none. Nothing when stopped: no file of
/// it is written then, and no folder is left that was not there. `limit_bytes`: of explicit fibres. Throws InputError;
/// where the folder cannot be written into, before the long work.
std::optional<HandoverReport> handOver(const HandoverPart& part, const DigitalClothOrder& order, double limit_bytes,
                                       const Task& task);

}  // namespace loomlight
