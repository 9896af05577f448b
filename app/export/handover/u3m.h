#pragma once

#include <chrono>
#include <string>

#include "app/export/handover/textures.h"

namespace loomlight {

/// A cloth as a digital material of U3M 1.1 (github.com/vizoogmbh/u3m): the text of a .u3m, whose pictures lie where
/// `front` and `back` say. What the format has no place for (mm of height, light through the cloth, the fit) is in its
/// custom section, under "loomlight". Its id is a function of the fabric alone.
std::string u3mText(const DigitalCloth& cloth, const SideTextures& front, const SideTextures& back,
                    std::chrono::sys_seconds now);

}  // namespace loomlight
