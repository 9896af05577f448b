#pragma once

#include <string>

namespace loomlight {

/// What `loomlight --version` says, one thing a line: version, commit, compiler, instruction set, libraries.
std::string versionText();

}  // namespace loomlight
