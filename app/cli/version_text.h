#pragma once

#include <string>

namespace loomlight {

/// What `loomlight --version` says, one thing a line: version, commit, compiler, the instruction set that this was
/// built for, the vector instructions that rays walk by here, processorKind(), libraries.
std::string versionText();

/// Version and commit, in one line. Builds that share it trace the same samples, whatever processors they are for, but
/// for what SampleOrigin::processor is about.
std::string buildName();

}  // namespace loomlight
