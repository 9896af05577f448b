#include "render/walk/walk_lanes.h"

#include <cmath>

namespace loomlight {

const SpreadPairs& SpreadPairs::table() {
  static const SpreadPairs instance(TangentSpread::table());
  return instance;
}

SpreadPairs::SpreadPairs(const TangentSpread& table) {
  const TangentSpread::View view = table.view();
  ratios = view.ratios;
  spreads = view.spreads;
  pairs.resize(static_cast<size_t>(ratios) * static_cast<size_t>(spreads));
  const auto code = [&](size_t i) { return static_cast<uint32_t>(std::lround(view.values[i] / kUnit)); };
  for (size_t i = 0; i < pairs.size(); ++i) {
    const bool last = i % static_cast<size_t>(ratios) + 1 == static_cast<size_t>(ratios);  // nobody asks beyond it
    pairs[i] = static_cast<int32_t>(code(i) | (last ? 0u : code(i + 1)) << 16);
  }
}

}  // namespace loomlight
