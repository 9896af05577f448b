#pragma once

#include <string>

#include "core/fabric/fabric.h"

namespace loomlight {

/// The fabric in a file of any kind that has one: a fabric (.json), a weave as a black-and-white picture (.png, with
/// the default yarns), or a picture that we rendered (.exr). Throws InputError.
Fabric fabricFromFile(const std::string& file);

}  // namespace loomlight
