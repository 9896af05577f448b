#include "core/fabric/yarn/yarn_need.h"

#include <cmath>

#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

/// How often each yarn comes among the first `count` of a sequence.
std::vector<double> countsOfYarns(const std::vector<int>& sequence, double count, size_t yarns) {
  std::vector<double> counts(yarns, 0);
  const auto period = static_cast<double>(sequence.size());
  const double whole = std::floor(count / period), rest = count - whole * period;
  for (size_t i = 0; i < sequence.size(); ++i)
    counts[static_cast<size_t>(sequence[i])] += whole + (static_cast<double>(i) < rest ? 1 : 0);
  return counts;
}

}  // namespace

std::vector<YarnNeed> yarnNeed(const Fabric& fabric, const PieceSize& piece, double crimpWarp, double crimpWeft) {
  const size_t yarns = fabric.yarns.size();
  const double ends = std::round(piece.width_cm * fabric.ends_per_cm);
  const double picks = std::round(100 * piece.length_m * fabric.picks_per_cm);
  const MillData& mill = fabric.mill;
  const double selvedges = 2.0 * mill.selvedgeEnds;
  std::vector<double> warp = countsOfYarns(fabric.warpSequence, ends + (mill.selvedgeYarn ? 0 : selvedges), yarns);
  if (mill.selvedgeYarn) warp[static_cast<size_t>(*mill.selvedgeYarn)] += selvedges;
  const std::vector<double> weft = countsOfYarns(fabric.weftSequence, picks, yarns);
  std::vector<YarnNeed> needs(yarns);
  for (size_t i = 0; i < yarns; ++i) {
    const Yarn& yarn = fabric.yarns[i];
    YarnNeed& need = needs[i];
    need.warp_m = warp[i] * piece.length_m * (1 + crimpWarp);
    need.weft_m = weft[i] * 0.01 * piece.width_cm * (1 + crimpWeft);
    need.mass_kg = 1e-6 * yarnCount_tex(yarn, meanFibre(yarn, fabric.fibres)) * (need.warp_m + need.weft_m);
  }
  return needs;
}

}  // namespace loomlight
