#pragma once

#include <string>

#include "app/export/handover/textures.h"

namespace loomlight {

/// A side of the cloth as a material of MaterialX 1.39 with an OpenPBR surface: the text of a .mtlx, whose pictures lie
/// where `textures` say. Thin-walled: its subsurface is light through the cloth, all of it forwards. Coordinates 0 to 1
/// are one tile. Fuzz stands for the sheen, though its lobe is another one.
std::string materialXText(const DigitalCloth& cloth, ClothSide side, const SideTextures& textures);

}  // namespace loomlight
