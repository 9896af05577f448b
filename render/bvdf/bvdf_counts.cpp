#include "render/bvdf/bvdf_counts.h"

namespace loomlight {
namespace {

constexpr int BvdfBin::* kAxes[] = {&BvdfBin::thetaO, &BvdfBin::phiO, &BvdfBin::thetaI, &BvdfBin::phiI};

/// visit(index, bin) for every bin, in the order of their indices.
template <class Visit>
void forEachBin(const BvdfResolution& r, Visit&& visit) {
  size_t index = 0;
  for (int to = 0; to < r.thetaO; ++to)
    for (int po = 0; po < r.phiO; ++po)
      for (int ti = 0; ti < r.thetaI; ++ti)
        for (int pi = 0; pi < r.phiI; ++pi) visit(index++, BvdfBin{to, po, ti, pi});
}

}  // namespace

std::vector<BvdfCounts::Bin> BvdfCounts::smoothed() const {
  std::vector<Bin> bins = bins_, before(bins.size());
  for (const auto axis : kAxes) {
    before.swap(bins);
    forEachBin(resolution_, [&](size_t index, BvdfBin bin) {
      const auto neighbour = [&](int step) {
        BvdfBin other = bin;
        other.*axis += step;
        return before[BvdfBin::wrapped(other, resolution_).index(resolution_)];
      };
      const Bin own = before[index], below = neighbour(-1), above = neighbour(1);
      bins[index] = {0.5f * own.met + 0.25f * (below.met + above.met),
                     0.5f * own.expected + 0.25f * (below.expected + above.expected)};
    });
  }
  return bins;
}

Bvdf BvdfCounts::table(HotSpot hotSpot) const {
  double met = 0, expected = 0;
  for (const Bin& bin : bins_) {
    met += bin.met;
    expected += bin.expected;
  }
  const auto mean = static_cast<float>(expected > 0 ? met / expected : 1.0);
  std::vector<float> ratios;
  ratios.reserve(bins_.size());
  for (const Bin& bin : smoothed()) ratios.push_back((bin.met + kPriorRays * mean) / (bin.expected + kPriorRays));
  return Bvdf(resolution_, hotSpot, std::move(ratios));
}

}  // namespace loomlight
