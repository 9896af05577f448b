#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A cloth that is edited, its whole repeat one piece; the camera looks at part of a large one, as whoever edits it
/// does.
struct EditedCloth {
  std::string name;  ///< also of files
  Fabric fabric;
};

/// 8 x 8 twill, 64 x 64 dobby, 1000 x 1000 and 4000 x 4000 jacquard; quick: the twill, the dobby and a jacquard of
/// 160 x 160, coarser.
std::vector<EditedCloth> editedCloths(bool quick);

/// One kind of edit.
struct EditKind {
  /// What of the volume it may put out of date. Undone or done again, no edit need voxelise anything.
  enum class Voxelises {
    nothing,
    crossing,  ///< what one crossing reaches: kMostOfCrossing bricks at most
    anything
  };
  std::string name;
  Voxelises voxelises = Voxelises::anything;
  /// Each of the first 64 rounds makes an edit that none before it has made, so that nothing of it is known.
  std::function<Fabric(Fabric fabric, int round)> apply;
};
inline constexpr int kMostOfCrossing = 64;

/// Every kind, in the order in which they are made.
std::vector<EditKind> editKinds();

/// A stroke across the weave: the fabrics after its first, second, ... crossing.
std::vector<Fabric> stroke(Fabric fabric, int crossings);

}  // namespace loomlight
