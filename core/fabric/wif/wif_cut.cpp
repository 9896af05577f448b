#include "core/base/period.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_thickness.h"
#include "core/fabric/wif/wif_yarns.h"

namespace loomlight {
namespace {

void cut(NumberLists& lists, int count) {
  if (lists.size() > static_cast<size_t>(count)) lists.resize(static_cast<size_t>(count));
}

void cut(std::map<int, double>& lengths, int threads) {
  lengths.erase(lengths.upper_bound(threads), lengths.end());
}

/// What is left of a sequence that went on for ever, as one for a repeat of so many threads.
std::vector<int> cut(const std::vector<int>& sequence, int threads) {
  std::vector<int> left;
  for (int thread = 0; thread < threads; ++thread)
    left.push_back(sequence[static_cast<size_t>(thread) % sequence.size()]);
  return shortestRepeat(std::move(left));
}

void cutSizes(WifSizes& sizes, int threads) {
  cut(sizes.spacings, threads);
  cut(sizes.thicknesses, threads);
}

}  // namespace

Fabric cutToNamed(Fabric fabric, WifNamed named) {
  const int ends = named.ends > 0 ? std::min(named.ends, fabric.weave.ends()) : fabric.weave.ends();
  const int picks = named.picks > 0 ? std::min(named.picks, fabric.weave.picks()) : fabric.weave.picks();
  if (fabric.draft) {
    cut(fabric.draft->threading, ends);
    cut(fabric.draft->treadling, picks);
    cut(fabric.draft->liftplan, picks);
  }
  fabric.weave = fabric.weave.resized(ends, picks);
  fabric.warpSequence = cut(fabric.warpSequence, ends);
  fabric.weftSequence = cut(fabric.weftSequence, picks);
  if (!fabric.wif) return fabric;
  WifOrigin origin = *fabric.wif;
  origin.ends = std::min(origin.ends, ends);
  origin.picks = std::min(origin.picks, picks);
  cutSizes(origin.rest.warp, origin.ends);
  cutSizes(origin.rest.weft, origin.picks);
  fabric.warpSpacing = spacingOf(origin.rest.warp, origin.ends);
  fabric.weftSpacing = spacingOf(origin.rest.weft, origin.picks);
  fabric.wif = withSizesOf(std::move(origin), fabric);
  return fabric;
}

}  // namespace loomlight
