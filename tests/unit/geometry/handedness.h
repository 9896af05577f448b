#pragma once

#include <gtest/gtest.h>

#include "core/geometry/cloth/cloth_geometry.h"
#include "core/geometry/yarn/pressing.h"

namespace loomlight {

/// The fibres of a cell of a straight yarn as they would lie were it not pressed.
inline CellStrands roundStrands(const ClothGeometry& cloth, const YarnCellKey& key) {
  const YarnGeometry& yarn = cloth.yarn(key.system, key.yarn);
  const SectionOutline node{key.here.up, key.here.across};
  const SectionEasing easing(node, node, yarn.free);
  CellStrands cell = cloth.strands(key);
  for (glm::vec3& p : cell.points) {
    const SectionScale section = yarn.withinOutline(easing.at(std::abs(p.y) / yarn.pitch_mm));
    p.x /= static_cast<float>(section.across);
    p.z = key.here.height_mm + (p.z - key.here.height_mm) / static_cast<float>(section.up);
  }
  return cell;
}

/// Mean of (r x dr/ds) . s over fibres, over mean r^2: turns per length of right-handed rotation, 1/mm, about the axis.
inline double handedness(const CellStrands& cell, double axisHeight_mm) {
  double rotation = 0, inertia = 0;
  for (const CellStrands::Strand& strand : cell.strands) {
    const glm::dvec3 a = cell.points[strand.first], b = cell.points[strand.first + strand.count - 1];
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
      const glm::dvec3 p = cell.points[i], q = cell.points[i + 1];
      const glm::dvec2 from(p.x, p.z - axisHeight_mm), to(q.x, q.z - axisHeight_mm);
      // (u, s, z) is right-handed, so a right-handed turn about +s goes from z to u.
      rotation += from.y * to.x - from.x * to.y;
      inertia += glm::dot(from, from) * (q.y - p.y);
    }
    EXPECT_GT(b.y, a.y);
  }
  return rotation / inertia / (2 * kPi);
}

}  // namespace loomlight
