#include "core/fabric/weave/structures.h"

#include <cassert>
#include <numeric>

#include "core/base/modulo.h"

namespace loomlight {
namespace {

/// A weave from a rule: warpOver(pick, end).
template <class Rule>
Weave fromRule(int ends, int picks, Rule&& warpOver) {
  std::vector<Weave::Row> rows(static_cast<size_t>(picks), Weave::Row(static_cast<size_t>(ends)));
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) rows[p][e] = warpOver(p, e) ? 1 : 0;
  return Weave(rows);
}

/// 0 1 .. n - 1 .. 1, of period 2 n - 2.
int pointed(int i, int n) {
  const int along = wrap(i, 2 * n - 2);
  return along < n ? along : 2 * n - 2 - along;
}

}  // namespace

Weave plainWeave() {
  return Weave();
}

Weave basket(int ends, int picks) {
  assert(ends >= 1 && picks >= 1);
  return fromRule(2 * ends, 2 * picks, [=](int p, int e) { return (p / picks + e / ends) % 2 == 0; });
}

Weave twill(int over, int under, Slant slant) {
  assert(over >= 1 && under >= 1);
  const int n = over + under;
  const int shift = slant == Slant::z ? -1 : 1;
  return fromRule(n, n, [=](int p, int e) { return wrap(e + shift * p, n) < over; });
}

Weave twill(const std::vector<int>& runs, int step, Slant slant) {
  assert(!runs.empty() && runs.size() % 2 == 0 && step >= 1);
  std::vector<bool> line;
  for (size_t i = 0; i < runs.size(); ++i) line.insert(line.end(), static_cast<size_t>(runs[i]), i % 2 == 0);
  const int n = static_cast<int>(line.size());
  // Ends that repeat their line sooner than n of them shorten the repeat.
  const int ends = n / std::gcd(n, step);
  const int direction = slant == Slant::z ? -1 : 1;
  return fromRule(ends, n, [&](int p, int e) { return line[static_cast<size_t>(wrap(p + direction * step * e, n))]; });
}

Weave pointTwill(int over, int under) {
  const int n = over + under;
  assert(over >= 1 && under >= 1 && n >= 3);
  return fromRule(2 * n - 2, n, [=](int p, int e) { return wrap(pointed(e, n) - p, n) < over; });
}

Weave diamondTwill(int over, int under) {
  const int n = over + under;
  assert(over >= 1 && under >= 1 && n >= 3);
  return fromRule(2 * n - 2, 2 * n - 2, [=](int p, int e) { return wrap(pointed(e, n) - pointed(p, n), n) < over; });
}

Weave brokenTwill(int over) {
  assert(over >= 1 && over <= 3);
  constexpr int kOrder[4] = {0, 1, 3, 2};
  return fromRule(4, 4, [&](int p, int e) { return wrap(e - kOrder[p], 4) < over; });
}

Weave herringbone(int over, int width) {
  assert(over >= 1 && width >= 1);
  const int n = 2 * over;
  // The second half runs the other way; its offset makes ends width - 1 and width, and the last and the first,
  // opposite.
  return fromRule(2 * width, n,
                  [=](int p, int e) { return e < width ? wrap(e - p, n) < over : wrap(e + p - 2 * width, n) < over; });
}

Weave satin(int ends, int step, Face face) {
  assert(step > 1 && step < ends - 1 && std::gcd(step, ends) == 1);
  const bool warp = face == Face::warp;
  return fromRule(ends, ends, [=](int p, int e) { return (e == (step * p) % ends) != warp; });
}

Weave shadedSatin(int ends, int step, int raised) {
  assert(step > 1 && step < ends - 1 && std::gcd(step, ends) == 1 && raised >= 1 && raised < ends);
  return fromRule(ends, ends, [=](int p, int e) { return wrap(e - step * p, ends) < raised; });
}

Weave waffle(int shafts) {
  assert(shafts >= 3);
  const int last = shafts - 1;
  return fromRule(2 * last, 2 * last, [=](int p, int e) {
    const int shaft = pointed(e, shafts), treadle = pointed(p, shafts);
    // Without the last condition the first shaft would never rise.
    return shaft > treadle || (shaft == 0 && treadle == last);
  });
}

Weave crepe() {
  return fromRule(8, 8, [](int p, int e) { return (p + e) % 2 == 0 || e == (3 * p + 1) % 8; });
}

Weave overshot(int blockEnds) {
  assert(blockEnds >= 2 && blockEnds % 2 == 0);
  constexpr int kBlocks[] = {0, 1, 2, 3, 2, 1};
  Draft draft;
  draft.shafts = 4;
  draft.treadles = 6;
  // Treadle b + 1 raises the two shafts of block b; 5 and 6 are the ground. Blocks share a shaft with the next one, and
  // odd and even shafts go on in turn over their borders.
  for (int block = 0; block < 4; ++block) draft.tieUp.push_back({block + 1, (block + 1) % 4 + 1});
  draft.tieUp.push_back({1, 3});
  draft.tieUp.push_back({2, 4});
  for (const int block : kBlocks)
    for (int i = 0; i < blockEnds; ++i) {
      const int odd = block % 2 == 0 ? block : (block + 1) % 4, even = block % 2 == 0 ? (block + 1) % 4 : block;
      draft.threading.push_back({(i % 2 == 0 ? odd : even) + 1});
      draft.treadling.push_back({block + 1});
      draft.treadling.push_back({i % 2 == 0 ? 5 : 6});
    }
  return drawdown(draft);
}

Weave doubleCloth(int over, int under) {
  const Weave single = over == 1 && under == 1 ? plainWeave() : twill(over, under);
  return fromRule(2 * single.ends(), 2 * single.picks(), [&](int p, int e) {
    const bool backPick = p % 2 == 1, backEnd = e % 2 == 1;
    if (backPick != backEnd) return backPick;  // the face lies above the back
    return single.at(p / 2, e / 2);
  });
}

std::vector<int> satinSteps(int ends) {
  std::vector<int> steps;
  for (int step = 2; step < ends - 1; ++step)
    if (std::gcd(step, ends) == 1) steps.push_back(step);
  return steps;
}

std::vector<Structure> structurePalette() {
  return {
      {"Plain", plainWeave()},
      {"Basket 2/2", basket(2, 2)},
      {"Warp rib", basket(1, 2)},
      {"Weft rib", basket(2, 1)},
      {"Twill 2/1", twill(2, 1)},
      {"Twill 2/2", twill(2, 2)},
      {"Twill 3/1", twill(3, 1)},
      {"Twill 1/3", twill(1, 3)},
      {"Twill 2/2 S", twill(2, 2, Slant::s)},
      {"Twill 3/1 S", twill(3, 1, Slant::s)},
      {"Broken twill 3/1", brokenTwill(3)},
      {"Broken twill 2/2", brokenTwill(2)},
      {"Herringbone", herringbone(2, 8)},
      {"Satin 5", satin(5, 2)},
      {"Sateen 5", satin(5, 2, Face::weft)},
      {"Satin 8", satin(8, 3)},
      {"Sateen 8", satin(8, 3, Face::weft)},
  };
}

}  // namespace loomlight
