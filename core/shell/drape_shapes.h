#pragma once

#include "core/shell/drape_mesh.h"

namespace loomlight {

// The drapes that show how a cloth hangs; see makeDrape. Their numbers are positive.

DrapeMesh foldedDrape(const Drape& drape);
DrapeMesh cushionDrape(const Drape& drape);
DrapeMesh skirtDrape(const Drape& drape);

}  // namespace loomlight
