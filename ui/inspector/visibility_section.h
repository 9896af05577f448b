#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// What is known of the local visibility of the yarn looked at.
struct VisibilityModel {
  ImTextureID picture{};  ///< squares in rows, without gaps; null: none yet
  int columns = 4, rows = 2;
  bool baking = false;
  double progress = 0;  ///< 0..1
  double rays = 0;      ///< that the picture is made of
  std::string error;
};

/// A section that folds; while it is shut there is nothing to be baked.
void visibilitySection(Ui& ui, const VisibilityModel& model, bool& open);

}  // namespace loomlight
