#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/model/weave.h"

namespace loomlight {

/// A yarn as a bundle of strands: all that the relaxation knows of it.
struct RelaxedYarn {
  double count_tex = 30;
  double density_g_cm3 = 1.52;
  double packing = 0.5;      ///< of the fibres in the free yarn
  double twist_per_m = 700;  ///< what holds its section round
};

/// Of the yarn where nothing presses it.
double freeRadius_mm(const RelaxedYarn& yarn);

/// One repeat of a weave of one warp and one weft yarn, that goes on for ever.
struct RelaxedCloth {
  Weave weave{{{1, 0}, {0, 1}}};
  double ends_per_cm = 20, picks_per_cm = 20;
  RelaxedYarn warp, weft;
};

struct Relaxation {
  double stiffnessPower = 2;        ///< a yarn's bending stiffness goes by its count to this, for equal fibres
  double tension_cN_tex = 0.5;      ///< on the loom, both systems
  double keptTension_cN_tex = 0.5;  ///< and off it: friction keeps in cloth what the loom gave
  double friction = 0.3;            ///< Coulomb's, between strands
  double plates = 1;                ///< presses the washed cloth to this part of its thickness; 1: not
  int loomSteps = 250, washedSteps = 2500;
};

/// How the yarns of a system lie at their crossings of one float state: at how many of its two neighbours along the
/// yarn it is on the same side. Means over these crossings.
struct RelaxedCrossings {
  int count = 0;
  double height_mm = 0;                     ///< of the yarn's axis from the middle of the cloth, towards its side
  double halfUp_mm = 0, halfAcross_mm = 0;  ///< of the section, as far as its strands reach
};

struct RelaxedMeasures {
  double crimpWarp = 0, crimpWeft = 0;
  double thickness_mm = 0;  ///< between the planes that one in a hundred of the strands' crowns goes beyond
  double overlap = 0;       ///< deepest of two strands, over the sum of their radii
  double drift = 0;         ///< what the crimps have changed by in the last fifth of the steps
  std::array<std::array<RelaxedCrossings, 3>, 2> crossings{};  ///< of warp and weft, by float state
  /// Of warp and weft, how much further a yarn stands from the neighbour that the thread it crosses parts it from than
  /// in an even sett, where that thread does not part it from the other one too. Mean over such crossings; 0 without.
  std::array<double, 2> drawnAside_mm{};
};

/// The shape that yarns of hard, bendable strands take, found by steps with nothing assumed of their sections or
/// heights: an oracle for the closed-form law. It knows nothing of core/geometry.
RelaxedMeasures relax(const RelaxedCloth& cloth, const Relaxation& how);

}  // namespace loomlight
