#pragma once

#include <vector>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/bench/relaxation.h"

namespace loomlight {

/// A construction that the closed-form law is compared with its relaxation on.
struct Construction {
  const char* name;
  bool wasFitted;  ///< one of the eight that the law's constants were read off
  RelaxedCloth cloth;
  RelaxedMeasures relaxed;  ///< as bench_relaxation found it: crimps, thickness, how far it is drawn aside
  /// Between plates, which closed by as much as Fabric::press of 0.5 makes ours thinner.
  RelaxedMeasures pressed;
  double plates = 1;             ///< that much, as a share of the thickness
  bool isUnlikePressed = false;  ///< its weft keeps more crimp between plates than ours does when it is pressed
  /// One yarn floats where its partners bend both ways, which cloth that does not crowd knows nothing of.
  bool isRib = false;
};
std::vector<Construction> constructions();

/// The same cloth, as the program makes it in closed form: even singles that flatten as most do. Fabric::press, 0
/// washed, and Fabric::crowding.
ClothMeasures inClosedForm(const RelaxedCloth& cloth, double press, double crowding = 0);
/// RelaxedMeasures::drawnAside_mm of the same cloth, washed, whose Fabric::crowding is 1.
std::array<double, 2> asideInClosedForm(const RelaxedCloth& cloth);

}  // namespace loomlight
