#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/weave.h"

namespace loomlight {

/// Basic weaves, by the numbers weavers name them with. Picks count up from the bottom of the drawn picture, so a Z
/// line climbs to the right, like the stroke of the letter.
enum class Slant { z, s };
/// Which system lies on the face.
enum class Face { warp, weft };

Weave plainWeave();
/// Yarns go in groups: `ends` side by side and `picks` side by side, >= 1. Basket 2/2 is basket(2, 2); (1, 2) is a
/// warp rib, (2, 1) a weft rib.
Weave basket(int ends, int picks);
/// Each end goes over `over` picks and under `under`, >= 1 both; the next end does the same one pick later.
Weave twill(int over, int under, Slant slant = Slant::z);
/// A twill of several runs: each end goes over and under in turn, (2 2 1 3) say, by an even number of runs, each >= 1.
/// The next end does so `step` picks later, >= 1: more makes the line steeper.
Weave twill(const std::vector<int>& runs, int step, Slant slant);
/// A twill on `over` + `under` shafts whose threading goes up and down: lines meet in points. Diamond: so does the
/// treadling, and points close to diamonds. Three shafts or more.
Weave pointTwill(int over, int under);
Weave diamondTwill(int over, int under);
/// A twill over `over` of four picks, 1..3, whose picks follow in the order 1 2 4 3, so that no line shows.
Weave brokenTwill(int over);
/// A balanced twill (over = under = `over`) that turns round every `width` ends, its colours opposed at the break.
Weave herringbone(int over, int width);
/// One binding point an end in a repeat of `ends`, `step` ends further with each pick: 1 < step < ends - 1, and no
/// common divisor (asserted: take it from satinSteps).
Weave satin(int ends, int step, Face face = Face::warp);
/// All steps that make a satin of that many ends; empty where there is none (fewer than 5, and 6).
std::vector<int> satinSteps(int ends);

/// A satin with `raised` adjoining crossings instead of one, 1..ends - 1: the steps of a damask between weft and warp.
Weave shadedSatin(int ends, int step, int raised);
/// Honeycomb on `shafts` shafts, >= 3, with floats that grow from 1 to 2 shafts - 3 towards ridges, and shrink again.
Weave waffle(int shafts);
/// Plain weave roughened by the points of an 8-end sateen, so that no line shows.
Weave crepe();
/// Pattern picks float in blocks over plain ground picks, on four shafts, after a pointed order of blocks of
/// `blockEnds` ends, even.
Weave overshot(int blockEnds);
/// Two cloths above each other, each a twill (1/1: plain), woven yarn by yarn in turn.
Weave doubleCloth(int over, int under);

struct Structure {
  std::string name;
  Weave weave;
};
/// What the editor offers at a click.
std::vector<Structure> structurePalette();

}  // namespace loomlight
