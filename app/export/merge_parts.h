#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/export/picture_part.h"
#include "core/base/task.h"

namespace loomlight {

/// What the parts of a picture say of themselves, taken together.
struct MergePlan {
  PartInfo info;                   ///< of what comes of them; its samples per pixel are the most that a part asks for
  std::vector<SampleBox> missing;  ///< of the whole picture
};

/// Reads only what files say of themselves, at least one. Throws InputError, which names the files, where parts are of
/// other fabrics, settings, seeds, meshes, environments or programs, hold the same samples, or hold no sums.
MergePlan planMerge(std::span<const std::string> files);

/// The sums of all parts, as one run over all of their samples gives them to the bit: a film of the whole picture.
/// Nothing when stopped. Throws InputError where a part has not all the samples that it was to have.
std::optional<Film> mergeParts(const MergePlan& plan, std::span<const std::string> files, const Task& task);

}  // namespace loomlight
