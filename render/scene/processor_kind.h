#pragma once

#include <string>

namespace loomlight {

/// Which kind of processor this is, as far as fibres in a tree show it (FibreBvh): processors of one kind meet them at
/// the same points to the last bit, as some thousand rays show. 16 hexadecimal digits, found within milliseconds.
/// Throws as EmbreeDevice does.
std::string processorKind();

}  // namespace loomlight
