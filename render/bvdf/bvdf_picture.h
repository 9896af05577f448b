#pragma once

#include "render/bvdf/bvdf_set.h"
#include "render/film/image.h"

namespace loomlight {

/// p of every bin of a table per yarn, as one channel each, "<table>.p". Laid out as in Fig. 8 of the report, but
/// whole: tiles of theta_o (down) by theta_i (to the right), phi_i from tile to tile to the right, phi_o downwards.
Image bvdfImage(const BvdfSet& set);

/// Fig. 8 of the report: a row of squares for each table, of theta_o in [0, 90] degrees (down) by theta_i in [0, 180]
/// (to the right), for phi_o = 0 and eight phi_i from 0 to 180 degrees. White: no shadow; black: all in shadow.
Pixels8 bvdfPicture(const BvdfSet& set);

/// The eight squares of one table, in rows of `columns` without gaps, to be laid out by who shows them.
Pixels8 bvdfSquares(const Bvdf& table, int columns);

}  // namespace loomlight
