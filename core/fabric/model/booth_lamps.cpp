#include "core/fabric/model/booth_lamps.h"

#include <algorithm>

namespace loomlight {

std::optional<StandardIlluminant> nextLamp(StandardIlluminant own, std::optional<StandardIlluminant> judged) {
  const auto* const begin = kBoothLamps.begin();
  const auto* const end = kBoothLamps.end();
  const auto* const now = std::find(begin, end, judged.value_or(own));
  const bool ownIsOfBooth = std::find(begin, end, own) != end;
  const auto* next = now == end ? begin : now + 1;
  if (next == end && ownIsOfBooth) next = begin;
  if (next == end || *next == own) return std::nullopt;
  return *next;
}

}  // namespace loomlight
