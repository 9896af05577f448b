#include "core/fabric/fabric.h"

#include <cassert>

namespace loomlight {
namespace {

int yarnAt(const std::vector<int>& sequence, int thread) {
  assert(!sequence.empty());
  const int n = static_cast<int>(sequence.size());
  const int r = thread % n;
  return sequence[r < 0 ? r + n : r];
}

}  // namespace

int Fabric::warpYarn(int end) const {
  return yarnAt(warpSequence, end);
}

int Fabric::weftYarn(int pick) const {
  return yarnAt(weftSequence, pick);
}

}  // namespace loomlight
