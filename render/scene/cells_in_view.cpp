#include "render/scene/cells_in_view.h"

#include <algorithm>
#include <limits>

#include "render/scene/shell_entry.h"

// How it works. A coarse grid of rays through the picture says where on the cloth each first meets it; the rectangle
// of cells about these places, with a margin of one interval of the grid and one cell, is what can be seen.

namespace loomlight {

CellRect cellsInView(const Camera& camera, double aspect, const ClothGeometry& geometry, const Shell& shell,
                     const ShellEntry& entry) {
  constexpr int kRays = 32;  // a side
  const int height = 4096, width = std::max(1, static_cast<int>(height * std::clamp(aspect, 1e-3, 1e3)));
  const CameraRays rays(camera, width, height);
  const glm::vec2 pitch_mm(geometry.warpPitch_mm(), geometry.weftPitch_mm());
  glm::vec2 lower(std::numeric_limits<float>::max()), upper(-lower);
  for (int y = 0; y <= kRays; ++y)
    for (int x = 0; x <= kRays; ++x) {
      const Ray ray = rays.ray(static_cast<float>(x * width) / kRays, static_cast<float>(y * height) / kRays);
      const auto hit = entry.enter(ray.origin, ray.direction, 0, std::numeric_limits<float>::max());
      if (!hit) continue;
      const glm::vec2 place = glm::vec2(shell.toCloth(hit->tet, ray.origin + hit->t * ray.direction)) / pitch_mm;
      lower = glm::min(lower, place);
      upper = glm::max(upper, place);
    }
  const glm::vec2 cells(geometry.ends(), geometry.picks());
  if (lower.x > upper.x) lower = upper = 0.5f * cells;
  // An edge of the cloth may lie between two rays, and yarns reach into the cells beside theirs.
  const glm::vec2 margin = 1.0f + (upper - lower) / static_cast<float>(kRays);
  lower = glm::clamp(lower - margin, glm::vec2(0), cells - 1.0f);
  upper = glm::clamp(upper + margin, lower, cells - 1.0f);
  const glm::ivec2 first(lower), last(upper);
  return {first.y, first.x, last.y - first.y + 1, last.x - first.x + 1};
}

}  // namespace loomlight
