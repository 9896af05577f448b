#pragma once

#include "core/fabric/model/glossary.h"

/// What pages and dialogs say alike.
namespace loomlight::words::panels {

inline constexpr const char* inspectorTabs[] = {words::yarnName.label, words::fibreName.label, "Cloth", "Scene"};
inline constexpr const char* draftTabs[] = {"Structures", "Loom", "Colours"};
inline constexpr const char* systems[] = {"Warp", "Weft"};
inline constexpr const char* none = "\xE2\x80\x93";  // where a value is not known, or there is none

}  // namespace loomlight::words::panels
