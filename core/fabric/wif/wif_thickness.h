#pragma once

#include <optional>
#include <vector>

#include "core/fabric/model/wif_document.h"
#include "core/fabric/wif/wif_warnings.h"

/// Thick and thin threads of a weaving file. Some programs give single threads a thickness, others only a spacing, the
/// room that the thread takes.
namespace loomlight {

/// The thickness that most of these threads have; nothing where the file gives none.
std::optional<double> usualThickness_mm(const WifSizes& sizes, int threads);

/// How many times as thick as most each of these threads is: by thickness where that differs, else by spacing, unless
/// the file gives a thickness that leaves a gap even in the narrowest room: then threads are set apart, not thick.
std::vector<double> relativeThickness(const WifSizes& sizes, int threads);

/// What a fabric has otherwise than the file because all its threads lie at one distance; nothing where they do so in
/// the file. `threads` in the file; `what` is what a system's threads are called, "Ends" or "Picks".
std::optional<WifWarning> unevenSpacing(const WifSizes& sizes, int threads, const char* what);

}  // namespace loomlight
