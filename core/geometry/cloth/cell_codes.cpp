#include "core/geometry/cloth/cell_codes.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/modulo.h"
#include "core/base/period.h"

// How it works. A cell's shape depends on five crossings, its own in their middle: three nodes, and the neighbours of
// each. Reading a row of cells therefore slides a window of five bits, one for each crossing (is this yarn over?),
// along the yarn; a table of all 32 windows, made when the program is compiled, gives sides and float states of the
// three nodes at once. A second window holds the kinds of the three threads that are crossed. Where threads crowd a
// third one holds what the crossings of the yarns beside it say: how far the yarn leans to either side there, and how
// the thread that it crosses floats. All packed together are the code, so a crossing of a jacquard costs few shifts and
// a look-up.
//
// The repeat of the codes is the least common multiple of the repeats of weave and yarn sequence, after each was
// reduced to its smallest period: the smallest divisor of its length after which it agrees with itself.

namespace loomlight {
namespace {

bool sameRow(std::span<const uint8_t> a, std::span<const uint8_t> b) {
  return a.data() == b.data() || std::equal(a.begin(), a.end(), b.begin());
}

/// Smallest p that divides the ends, with which every pick repeats.
int smallestPeriodOfEnds(const Weave& weave) {
  // The periods of a pick that divide n are the multiples of its smallest, so each pick goes on from the one before.
  const std::vector<int> divisors = divisorsOf(weave.ends());
  auto period = divisors.begin();
  for (int pick = 0; pick < weave.picks() && *period < weave.ends(); ++pick) {
    const auto row = weave.row(pick);
    const int step = *period;
    while (*period % step != 0 || !sameRow(row.subspan(static_cast<size_t>(*period)), row.first(row.size() - *period)))
      ++period;
  }
  return *period;
}

int leastCommonMultiple(int a, int b) {
  const int64_t multiple = std::lcm(static_cast<int64_t>(a), static_cast<int64_t>(b));
  return static_cast<int>(std::min<int64_t>(multiple, std::numeric_limits<int>::max()));
}

// What one node of a path comes from: the float state in 2 bits, the side in 1, the leaning in 4, the float state of
// the yarn that is crossed in 2, its kind in kKindBits. A cell's shape code has its own kind above those of its three
// nodes.
constexpr int kFloatBits = 3, kOverBit = 4, kLeaningBits = 4, kOtherShift = kFloatBits + kLeaningBits;
constexpr int kOtherBits = 2, kKindShift = kOtherShift + kOtherBits;
constexpr int kKindBits = 9, kNodeBits = kKindShift + kKindBits;
constexpr ShapeCode kThreeNodes = (ShapeCode{1} << (3 * kNodeBits)) - 1;
static_assert(kFloatStates <= kOverBit && kMaxThreadKinds <= 1 << kKindBits);

/// What the sides of the yarns before and after one say of a crossing on it.
struct Beside {
  /// To which of them it is drawn: 1 the one after it, -1 the one before it, 0 neither, as the crossing thread parts it
  /// from both or from none.
  int drawn = 0;
  /// The float state of the crossing thread, kAsOwn where nothing is asked of those yarns.
  int otherState = 0;
};
constexpr int kAsOwn = kFloatStates;
constexpr Beside besideOf(bool own, bool before, bool after) {
  return {(own != before) - (own != after), (own == before) + (own == after)};
}
constexpr auto kNothingAsked = [](int) { return Beside{0, kAsOwn}; };

/// A leaning, of either sign, as it stands in a code and back.
constexpr ShapeCode codeOfLeaning(int leaning) {
  return static_cast<ShapeCode>(leaning & ((1 << kLeaningBits) - 1)) << kFloatBits;
}
constexpr int leaningOf(int node) {
  constexpr int kSign = 1 << (kLeaningBits - 1);
  const int bits = node >> kFloatBits & ((1 << kLeaningBits) - 1);
  return (bits ^ kSign) - kSign;
}
static_assert(leaningOf(static_cast<int>(codeOfLeaning(-kMostLeaning))) == -kMostLeaning);
static_assert(leaningOf(static_cast<int>(codeOfLeaning(kMostLeaning))) == kMostLeaning);

// The sides at the three nodes of a cell and the crossings beside them, one bit each, tell how the yarn floats at each
// node: a table, because there is one look-up for every crossing of a jacquard.
constexpr int kReach = kCrossingReach, kSidesSeen = 2 * kReach + 1;

constexpr std::array<ShapeCode, 1 << kSidesSeen> makeFloatCodes() {
  std::array<ShapeCode, 1 << kSidesSeen> codes{};
  for (unsigned sides = 0; sides < codes.size(); ++sides) {
    const auto over = [sides](int i) { return (sides >> i & 1u) != 0; };
    for (int node = 0; node < 3; ++node) {
      const int i = kReach - 1 + node;
      const int state = (over(i - 1) == over(i)) + (over(i + 1) == over(i));
      codes[sides] = codes[sides] << kNodeBits | static_cast<ShapeCode>((over(i) ? kOverBit : 0) | state);
    }
  }
  return codes;
}
constexpr auto kFloatCodes = makeFloatCodes();

}  // namespace

CellCodes::CellCodes(const Weave& weave, std::array<std::vector<int>, 2> kinds, bool crowded)
    : weave_(weave), kinds_(std::move(kinds)), crowded_(crowded) {
  const int weavePicks =
      smallestPeriod(weave_.picks(), [&](int a, int b) { return sameRow(weave_.row(a), weave_.row(b)); });
  const int weaveEnds = smallestPeriodOfEnds(weave_);
  repeatEnds_ = leastCommonMultiple(weaveEnds, static_cast<int>(kinds_[0].size()));
  repeatPicks_ = leastCommonMultiple(weavePicks, static_cast<int>(kinds_[1].size()));
}

int CellCodes::kind(System system, int index) const {
  const std::vector<int>& all = kinds(system);
  return all[wrap(index, static_cast<int>(all.size()))];
}

/// warpOver(i), beside(i): of the crossing at i along the yarn, 0 <= i < as many as the weave has.
template <class WarpOver, class BesideAt>
void CellCodes::readOf(System system, int across, int along, const WarpOver& warpOver, const BesideAt& besideAt,
                       std::span<ShapeCode> codes) const {
  const bool warp = system == System::warp;
  const int alongCount = warp ? weave_.picks() : weave_.ends();
  const std::vector<int>& others = kinds(crossSystem(system));
  const ShapeCode own = static_cast<ShapeCode>(kind(system, across)) << (3 * kNodeBits);

  // All slide along the yarn: the sides of the crossings in reach, what those of the yarns beside make of each, which
  // is one behind as it counts the crossing that is just seen, and the kinds of the three threads that are crossed.
  int ahead = wrap(along - kReach, alongCount);
  unsigned sides = 0;
  ShapeCode crowded = 0;
  Beside before, here;
  const auto see = [&] {
    const bool over = warpOver(ahead) == warp;
    sides = sides >> 1 | static_cast<unsigned>(over) << (kSidesSeen - 1);
    const Beside after = besideAt(ahead);
    crowded = (crowded << kNodeBits | codeOfLeaning(kLeaning * here.drawn + before.drawn + after.drawn) |
               static_cast<ShapeCode>(here.otherState) << kOtherShift) &
              kThreeNodes;
    before = std::exchange(here, after);
    if (++ahead == alongCount) ahead = 0;
  };
  for (int i = 0; i < kSidesSeen - 1; ++i) see();
  auto other = static_cast<size_t>(wrap(along - 1, static_cast<int>(others.size())));
  ShapeCode crossed = 0;
  const auto cross = [&] {
    crossed = (crossed << kNodeBits | static_cast<ShapeCode>(others[other]) << kKindShift) & kThreeNodes;
    if (++other == others.size()) other = 0;
  };
  cross();
  cross();
  for (ShapeCode& code : codes) {
    see();
    cross();
    code = own | crossed | crowded | kFloatCodes[sides];
  }
}

void CellCodes::read(System system, int across, int along, const YarnCrossings& crossings,
                     std::span<ShapeCode> codes) const {
  const uint8_t *const own = crossings.own.data(), *const before = crossings.before.data(),
                       *const after = crossings.after.data();
  const auto warpOver = [own](int i) { return own[i] != 0; };
  if (crowded_) {
    const auto beside = [=](int i) { return besideOf(own[i] != 0, before[i] != 0, after[i] != 0); };
    readOf(system, across, along, warpOver, beside, codes);
  } else {
    readOf(system, across, along, warpOver, kNothingAsked, codes);
  }
}

void CellCodes::read(System system, int across, int along, std::span<ShapeCode> codes) const {
  if (system == System::weft) {
    const auto row = [this](int pick) { return weave_.row(wrap(pick, weave_.picks())); };
    read(system, across, along, {row(across), row(across - 1), row(across + 1)}, codes);
    return;
  }
  const auto column = [this](int index) {
    return [this, end = wrap(index, weave_.ends())](int pick) { return weave_.at(pick, end); };
  };
  const auto own = column(across);
  if (crowded_) {
    const auto beside = [own, before = column(across - 1), after = column(across + 1)](int pick) {
      return besideOf(own(pick), before(pick), after(pick));
    };
    readOf(system, across, along, own, beside, codes);
  } else {
    readOf(system, across, along, own, kNothingAsked, codes);
  }
}

CellShape shapeOf(ShapeCode code) {
  const auto nodeAt = [code](int place) {
    const int bits = static_cast<int>(code >> (place * kNodeBits)) & ((1 << kNodeBits) - 1);
    const int floatState = bits & (kOverBit - 1), other = bits >> kOtherShift & ((1 << kOtherBits) - 1);
    return CellShape::Node{bits >> kKindShift, (bits & kOverBit) != 0, floatState, other == kAsOwn ? floatState : other,
                           leaningOf(bits)};
  };
  return {static_cast<int>(code >> (3 * kNodeBits)), nodeAt(2), nodeAt(1), nodeAt(0)};
}

ShapeCode renamed(System system, ShapeCode code, const KindNames& names) {
  const auto own = static_cast<size_t>(system), crossed = 1 - own;
  const auto name = [](const std::vector<int>& of, ShapeCode number) {
    return static_cast<ShapeCode>(of[static_cast<size_t>(number)]);
  };
  ShapeCode result = name(names[own], code >> (3 * kNodeBits)) << (3 * kNodeBits);
  for (int place = 0; place < 3; ++place) {
    const ShapeCode node = code >> (place * kNodeBits) & ((1 << kNodeBits) - 1);
    const ShapeCode lying = node & ((1 << kKindShift) - 1);
    result |= (name(names[crossed], node >> kKindShift) << kKindShift | lying) << (place * kNodeBits);
  }
  return result;
}

}  // namespace loomlight
