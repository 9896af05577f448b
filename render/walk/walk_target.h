#pragma once

namespace loomlight {

/// The vector instructions that walk() uses on this processor, by Highway's name for them ("AVX2", "SSE4"): found out
/// while the program runs, whatever it was built for.
const char* walkTarget();

}  // namespace loomlight
