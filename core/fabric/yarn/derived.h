#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Peirce's cover factors: ends or picks per inch over the square root of the cotton count, averaged over the yarn
/// sequences. At 28 round yarns touch; most cloths lie near 12 each way. Counts and setts alone are in them: what yarns
/// cover as they lie in the cloth, wider than round, is ClothMeasures::cover.
struct CoverFactors {
  double warp = 0;
  double weft = 0;
  double cloth = 0;     ///< warp + weft - warp * weft / 28 with at most 28 of each
  double fraction = 0;  ///< cloth / 28: the share of the plane that round yarns of cotton would cover, at most 1
};
CoverFactors coverFactors(const Fabric& fabric);

/// Longest floats of a weave, in crossings; the repeat goes on for ever, so floats run on over its edges. A warp float
/// lies on the face where the warp is over. Ends and picks that never change sides have no float: they are counted
/// apart.
struct Floats {
  int warpFace = 0;
  int warpBack = 0;
  int weftFace = 0;
  int weftBack = 0;
  int idleEnds = 0;  ///< ends of the repeat that never interlace
  int idlePicks = 0;

  int warp() const { return warpFace > warpBack ? warpFace : warpBack; }
  int weft() const { return weftFace > weftBack ? weftFace : weftBack; }
};
Floats floats(const Weave& weave);
/// Length of a float of `cells` crossings, mm: the warp floats over picks, the weft over ends.
double floatLength_mm(const Fabric& fabric, System system, int cells);

/// Sides of a crossing in a drawing by the sett, the shorter one 1; so that a circle in the draft is one in the cloth.
/// At most 8, to be drawn at all.
struct CrossingShape {
  double width = 1, height = 1;
};
CrossingShape crossingShape(const Fabric& fabric);

/// Until weave and order of colours repeat together: ends or picks of the pattern. The smallest number that both
/// divide.
int64_t patternEnds(const Fabric& fabric);
int64_t patternPicks(const Fabric& fabric);

/// How tightly and how evenly a weave binds, over one repeat.
struct Binding {
  int64_t warpUpCells = 0;       ///< crossings with the warp on the face
  double warpOnFace = 0;         ///< the same as a share, 0..1; a balanced weave has 1/2
  int64_t warpInterlacings = 0;  ///< changes of side along all ends
  int64_t weftInterlacings = 0;  ///< changes of side along all picks
};
Binding binding(const Weave& weave);

/// Mean linear density of a system's yarns over its sequence, tex.
double meanCount_tex(const Fabric& fabric, System system);

/// Mean diameter of a system's yarns over its sequence, as if they were round, mm.
double meanDiameter_mm(const Fabric& fabric, System system);
/// The same of each thread of the sequence, mm.
std::vector<double> threadDiameters_mm(const Fabric& fabric, System system);

/// Mass of a square metre, g: 0.1 (n1 T1 (1 + c1) + n2 T2 (1 + c2)), ends and picks per cm and tex. The crimps are what
/// the geometry measures, or a guess.
double arealMass_g_m2(const Fabric& fabric, double crimpWarp, double crimpWeft);

/// How close the sett is to the closest that the yarns allow, by Peirce's geometry of round yarns that touch: at 1 the
/// cloth is jammed. For weaves with floats the pitch is that of an interlacing, with the threads under a float side by
/// side. 0 for open cloth.
double jamming(const Fabric& fabric);

struct LongFloats;
/// What a weaver would object to, in plain words: jammed sett, floats longer than they may be, yarns with no
/// interlacing; and what no spinner could make: more slubs than there is room for, yarns more even than chance.
/// `floats` and `tooLong`: of this fabric.
std::vector<std::string> warnings(const Fabric& fabric, const Floats& floats, const LongFloats& tooLong);

}  // namespace loomlight
