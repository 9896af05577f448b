#pragma once

#include <span>
#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Names of enumerations as a designer reads them, in the order of the enumerators.
/// A picture can be chosen once there is a file.
std::span<const char* const> lightNames(const Light& light);
/// The light turned into another kind, and into what that kind can be: no sun shines from below the horizon.
Light withKind(Light light, LightKind kind);
/// A mesh can be chosen once there is a file.
std::span<const char* const> drapeNames(const Drape& drape);
std::span<const char* const> fibreSectionNames();
std::span<const char* const> twistNames();
std::span<const char* const> layoutNames();
std::span<const char* const> illuminantNames(const Light& light);
/// As lists and labels say it: "F11, shop (TL84)".
const char* lampLabel(StandardIlluminant lamp);
/// In few letters: "F11".
std::string lampWord(StandardIlluminant lamp);
std::span<const char* const> observerNames();
std::span<const char* const> methodNames();
std::span<const char* const> estimatorNames();
std::span<const char* const> eventLawNames();

}  // namespace loomlight
