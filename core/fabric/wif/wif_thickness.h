#pragma once

#include <optional>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/model/wif_document.h"
#include "core/fabric/wif/wif_warnings.h"

/// Thick and thin threads of a weaving file. Some programs give single threads a thickness, others only a spacing, the
/// room that the thread takes.
namespace loomlight {

/// The thickness that most of these threads have; nothing where the file gives none, or only that of a few.
std::optional<double> usualThickness_mm(const WifSizes& sizes, int threads);

/// How many times as thick as most each of these threads is: by thickness where that differs, else by spacing, unless
/// the file gives a thickness that leaves a gap even in the narrowest room: then threads are set apart, not thick.
std::vector<double> relativeThickness(const WifSizes& sizes, int threads);

/// Whether single threads have a spacing or a thickness, and nothing gives that of the others.
bool hasGaps(const WifSizes& sizes, int threads);
/// Of how many threads, from the first, sizes are to be expected: where there are gaps, as far as the draft names its
/// threads (WifNamed), since those beyond are empty.
int sizedThreads(const WifSizes& sizes, int threads, int named);
/// Says where there are gaps, and what comes of it.
void noteGaps(const WifSizes& sizes, System system, int threads, WifWarnings& warnings);

/// Fabric::warpSpacing or weftSpacing of these threads: from thread to thread what the file says; but where it says by
/// spacing which threads are thick, each lies in the middle of its room. Empty where they lie at one distance, or
/// repeat after more than kMostSpacing threads.
std::vector<double> spacingOf(const WifSizes& sizes, int threads);

/// What the file says of threads that lie unevenly, and what becomes of that; nothing where they do not. `threads` in
/// the file; `what` is what a system's threads are called, "Ends" or "Picks"; `isWoven`: whether the fabric has it.
std::optional<WifWarning> unevenSpacing(const WifSizes& sizes, int threads, const char* what, bool isWoven);

}  // namespace loomlight
