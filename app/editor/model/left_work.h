#pragma once

#include <filesystem>
#include <string>

namespace loomlight {

/// Which work an ended editor has left in that copy, and since when, as a sentence. Looks at the beginning of the file
/// alone, however large the cloth; says less of a file that does not tell its name.
std::string aboutLeftWork(const std::filesystem::path& left);

}  // namespace loomlight
