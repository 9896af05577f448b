#pragma once

#include "render/media/medium.h"

namespace loomlight {

/// Where light that leaves the fibre of a collision into direction wi comes out of its surface, for a collision that
/// knows its axis. About the axis every mode leaves as far beyond its exit normal as it came in before the normal it
/// came in by (the angular momentum is kept); along the fibre it has gone on as it came, refracted, on each traverse.
/// `length_radii`: what it has travelled in the fibre; 0 where it was reflected.
glm::vec3 fibreExit(const TraceData& cloth, const Collision& collision, glm::vec3 wi, float length_radii);

/// How far light travels in one traverse of the fibre just met.
float traverse_radii(const TraceData& cloth, const Collision& collision);

}  // namespace loomlight
