#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ui/widgets/ui.h"

namespace loomlight {

/// Where the fibres of a yarn cut its cross-section, in the cloth: the very strands that are voxelised.
struct YarnSection {
  struct Point {
    glm::vec2 at_mm{0};  ///< across the yarn, and up
    uint8_t ply = 0;
    bool hair = false;
    bool second = false;  ///< of the blend's second fibre
  };
  std::vector<Point> points;
  double fibreRadius_mm = 0;
  double halfWidth_mm = 0, halfHeight_mm = 0;
};

/// Display colours of a yarn's fibre, and of the second one of a blend.
struct YarnFibreColours {
  ImVec4 first, second;
};

/// Proportions of the picture that drawYarnCloseUp shows, at scale 1.
inline constexpr float kCloseUpWidth = 144, kCloseUpHeight = 128;

/// Draws it to scale, with a scale bar.
void drawYarnSection(Ui& ui, const YarnSection& section, const YarnFibreColours& colours, ImVec2 size);
/// The yarn as a magnifying glass shows it, beside its section; null: no picture yet.
void drawYarnCloseUp(Ui& ui, ImTextureID picture, ImVec2 size);

}  // namespace loomlight
