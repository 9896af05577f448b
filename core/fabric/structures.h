#pragma once

#include <string>
#include <vector>

#include "core/fabric/weave.h"

namespace loomlight {

/// Basic weaves, by the numbers weavers name them with. Picks count up from the bottom of the drawn picture, so a Z
/// line climbs to the right, like the stroke of the letter.
enum class Slant { z, s };
/// Which system lies on the face.
enum class Face { warp, weft };

Weave plainWeave();
/// Threads go in groups: `ends` side by side and `picks` side by side, >= 1. Basket 2/2 is basket(2, 2); (1, 2) is a
/// warp rib, (2, 1) a weft rib.
Weave basket(int ends, int picks);
/// Each end goes over `over` picks and under `under`, >= 1 both; the next end does the same one pick later.
Weave twill(int over, int under, Slant slant = Slant::z);
/// A twill over `over` of four picks, 1..3, whose picks follow in the order 1 2 4 3, so that no line shows.
Weave brokenTwill(int over);
/// A balanced twill (over = under = `over`) that turns round every `width` ends, its colours opposed at the break.
Weave herringbone(int over, int width);
/// One binding point an end in a repeat of `ends`, `step` ends further with each pick: 1 < step < ends - 1, and no
/// common divisor (asserted: take it from satinSteps).
Weave satin(int ends, int step, Face face = Face::warp);
/// All steps that make a satin of that many ends; empty where there is none (fewer than 5, and 6).
std::vector<int> satinSteps(int ends);

struct Structure {
  std::string name;
  Weave weave;
};
/// What the editor offers at a click.
std::vector<Structure> structurePalette();

}  // namespace loomlight
