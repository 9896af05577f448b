#pragma once

#include "core/fabric/model/glossary.h"

/// What the page of the scene says.
namespace loomlight::words::scenePage {

inline constexpr const char* light = "Light";
inline constexpr const char* onlyToJudge = "To judge by; the cloth keeps {}.";
inline constexpr Word chooseEnvironment{"Choose an environment\xE2\x80\xA6",
                                        "A latitude-longitude picture (EXR) that lights the cloth from all around"};
inline constexpr const char* drape = "Drape";
inline constexpr Word chooseMesh{"Choose a mesh\xE2\x80\xA6",
                                 "OBJ, PLY or OFF with texture coordinates: the cloth lies on it as the coordinates "
                                 "say"};
inline constexpr const char* camera = "Camera";
inline constexpr const char* detail = "Detail";

}  // namespace loomlight::words::scenePage
