#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/colour/colour_space.h"
#include "render/transport/colour_patch.h"

namespace loomlight {

/// How the cloth looks from above where something lies on top, for the CIE observer of 10 degrees, as the textile trade
/// measures.
struct FaceColour {
  std::string name;        ///< of the fibre; "Cloth" for all of the face
  Rgb shown{0};            ///< linear; in daylight, for the observer of 2 degrees, as displays are meant for
  Lab daylight, bulb;      ///< under CIE D65 and A
  double inconstancy = 0;  ///< CIEDE2000 between the two: how far the lamp moves it
};

/// How many faceColours() tells at most.
int facesToTell(const Fabric& fabric);

/// Of all of the face, and of at most three of its fibres where it has several, of the cloth of this patch. nullopt
/// when stopped.
std::optional<std::vector<FaceColour>> faceColours(const ColourPatch& patch, const Task& task);

}  // namespace loomlight
