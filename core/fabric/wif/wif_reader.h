#pragma once

#include <string>
#include <string_view>

#include "core/fabric/model/wif_document.h"
#include "core/fabric/wif/wif_counting.h"
#include "core/fabric/wif/wif_sections.h"
#include "core/fabric/wif/wif_warnings.h"

namespace loomlight {

/// Reads a weaving file as tolerantly as its meaning allows: whatever is missing, out of range or contradictory is
/// taken as the warnings say, and nothing is dropped without one. Throws InputError, naming `source`, only for what
/// holds no draft, or one larger than a Weave can be.
///
/// Threads= of [WARP] and [WEFT] says how large the draft is, wherever it is sensible; threads that no line names hang
/// on no shaft, or press no treadle. Shafts and treadles that are used are there, whatever [WEAVING] says. A LIFTPLAN
/// comes before TIEUP and TREADLING. Without "Rising Shed" the shed rises (the specification says that an absent switch
/// is off; nearly all programs mean it on).
WifDocument readWif(std::string_view bytes, const std::string& source, WifWarnings& warnings);

/// Parts of the above.
/// Shafts, treadles, threading, tie-up, treadling and liftplan.
Draft readWifDraft(const WifSections& sections, const WifCounting& counting, const std::string& source,
                   WifWarnings& warnings, WifNamed& named);
/// The colours, by number from 1.
WifPalette readWifPalette(const WifSections& sections, const WifCounting& counting, WifWarnings& warnings);
/// Numbers of the palette for the threads of a system, 0 where there is none.
std::vector<int> readWifColours(const WifSections& sections, const WifCounting& counting, System system, int threads,
                                const WifPalette& palette, WifWarnings& warnings);
/// All that a fabric does not hold.
WifRest readWifRest(const WifSections& sections, const WifCounting& counting, WifWarnings& warnings);

}  // namespace loomlight
