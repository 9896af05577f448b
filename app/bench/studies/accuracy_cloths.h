#pragma once

#include <vector>

#include "app/bench/studies/bench_cloths.h"

namespace loomlight {

/// What the volume's accuracy is measured on, six kinds of cloth that ask different things of it: a plain weave of
/// filament, the report's twill (fibres laid at random), a dense satin, a sheer silk, spun and hairy wool, and black
/// warp on white weft. Colours are such that every channel of every cloth sends light enough to be measured.
std::vector<BenchCloth> accuracyCloths();
/// Cloths that are worn, of fibres that stray and stand off in yarns and a sett that are uneven.
std::vector<BenchCloth> realCloths();

}  // namespace loomlight
