#include "core/fabric/yarn/long_floats.h"

#include <algorithm>

#include "core/fabric/yarn/derived.h"

// How it works. Every end and pick is a ring of crossings, cut where it changes sides: each part is a float, whose
// length follows from the sett. The longest are kept by cutting a growing list down to a few now and then, so that a
// jacquard of millions of floats takes no more memory than a plain cloth.

namespace loomlight {
namespace {

/// Those of one thread, which runs through `count` crossings and round again. `isUp(i)`: the warp is over there.
template <class IsUp, class Note>
void eachFloat(int count, const IsUp& isUp, const Note& note) {
  int start = 0;
  while (start < count && isUp(start) == isUp((start + count - 1) % count)) ++start;
  if (start == count) return note(0, count, isUp(0), true);
  for (int i = 0; i < count;) {
    const bool up = isUp((start + i) % count);
    int cells = 1;
    while (i + cells < count && isUp((start + i + cells) % count) == up) ++cells;
    note((start + i) % count, cells, up, false);
    i += cells;
  }
}

bool comesFirst(const FloatRun& a, const FloatRun& b) {
  if (a.isEndless != b.isEndless) return a.isEndless;
  if (a.length_mm != b.length_mm) return a.length_mm > b.length_mm;
  if (a.system != b.system) return a.system < b.system;
  return a.across != b.across ? a.across < b.across : a.first < b.first;
}

}  // namespace

FloatLimits floatLimits(const Fabric& fabric, double limit_mm) {
  const auto cells = [&](System system) {
    constexpr double kRounding = 1e-9;
    const double one_mm = floatLength_mm(fabric, system, 1);
    return static_cast<int>(std::min(limit_mm / one_mm * (1 + kRounding), static_cast<double>(Weave::kMaxSide)));
  };
  return {cells(System::warp), cells(System::weft)};
}

bool floatsTooFar(const Weave& weave, int pick, int end, const FloatLimits& limits) {
  const bool up = weave.warpOver(pick, end);
  const auto isLong = [&](int most, const auto& upAt) {
    int length = 1;
    for (int step = 1; length <= most && upAt(step) == up; ++step) ++length;
    for (int step = 1; length <= most && upAt(-step) == up; ++step) ++length;
    return length > most;
  };
  return isLong(limits.warp, [&](int step) { return weave.warpOver(pick + step, end); }) ||
         isLong(limits.weft, [&](int step) { return weave.warpOver(pick, end + step); });
}

LongFloats longFloats(const Fabric& fabric, double limit_mm) {
  const Weave& weave = fabric.weave;
  const FloatLimits limits = floatLimits(fabric, limit_mm);
  LongFloats found;
  found.limit_mm = limit_mm;
  const auto noteOf = [&](System system, int across) {
    const int most = system == System::warp ? limits.warp : limits.weft;
    return [&found, &fabric, system, across, most](int first, int cells, bool up, bool isEndless) {
      if (!isEndless && cells <= most) return;
      ++found.count;
      found.longest.push_back({system, up == (system == System::warp), across, first, cells, isEndless,
                               floatLength_mm(fabric, system, cells)});
      if (found.longest.size() < 4 * LongFloats::kMostListed) return;
      std::partial_sort(found.longest.begin(), found.longest.begin() + LongFloats::kMostListed, found.longest.end(),
                        comesFirst);
      found.longest.resize(LongFloats::kMostListed);
    };
  };
  for (int pick = 0; pick < weave.picks(); ++pick) {
    const std::span<const uint8_t> row = weave.row(pick);
    eachFloat(weave.ends(), [row](int end) { return row[static_cast<size_t>(end)] != 0; }, noteOf(System::weft, pick));
  }
  for (int end = 0; end < weave.ends(); ++end)
    eachFloat(
        weave.picks(), [&](int pick) { return weave.row(pick)[static_cast<size_t>(end)] != 0; },
        noteOf(System::warp, end));
  std::sort(found.longest.begin(), found.longest.end(), comesFirst);
  if (found.longest.size() > LongFloats::kMostListed) found.longest.resize(LongFloats::kMostListed);
  return found;
}

}  // namespace loomlight
