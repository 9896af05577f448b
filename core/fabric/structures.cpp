#include "core/fabric/structures.h"

#include <cassert>
#include <numeric>

namespace loomlight {
namespace {

int modulo(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// A weave from a rule: warpOver(pick, end).
template <class Rule>
Weave fromRule(int ends, int picks, Rule&& warpOver) {
  std::vector<Weave::Row> rows(static_cast<size_t>(picks), Weave::Row(static_cast<size_t>(ends)));
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) rows[p][e] = warpOver(p, e) ? 1 : 0;
  return Weave(rows);
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
  return fromRule(n, n, [=](int p, int e) { return modulo(e + shift * p, n) < over; });
}

Weave brokenTwill(int over) {
  assert(over >= 1 && over <= 3);
  constexpr int kOrder[4] = {0, 1, 3, 2};
  return fromRule(4, 4, [&](int p, int e) { return modulo(e - kOrder[p], 4) < over; });
}

Weave herringbone(int over, int width) {
  assert(over >= 1 && width >= 1);
  const int n = 2 * over;
  // The second half runs the other way; its offset makes ends width - 1 and width, and the last and the first,
  // opposite.
  return fromRule(2 * width, n, [=](int p, int e) {
    return e < width ? modulo(e - p, n) < over : modulo(e + p - 2 * width, n) < over;
  });
}

Weave satin(int ends, int step, Face face) {
  assert(step > 1 && step < ends - 1 && std::gcd(step, ends) == 1);
  const bool warp = face == Face::warp;
  return fromRule(ends, ends, [=](int p, int e) { return (e == (step * p) % ends) != warp; });
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
