#pragma once

#include <optional>
#include <string>

#include "render/metrics/flip.h"

namespace loomlight {

/// Names of two pictures: one that is looked at, and what it ought to look like.
struct PictureNames {
  std::string picture, reference;
};

/// loomlight compare PICTURE REFERENCE
struct CompareCommand {
  PictureNames pictures;
  std::optional<PictureNames> again;  ///< the same two, rendered with other seeds
  /// Two fibre arrangements of the same yarns: what is as close as they are to each other is as close as can be asked.
  std::optional<PictureNames> yardstick;
  std::optional<PictureNames> yardstickAgain;  ///< with other seeds
  Viewing viewing;
  std::string heatMap;  ///< .png; empty: none
  double heatRange = 1;
  int threads = 0;  ///< 0: all
  bool json = false;
};

/// A table, or JSON, on stdout. Exit status 0, whatever the differences. Throws InputError.
int run(const CompareCommand& command);

}  // namespace loomlight
