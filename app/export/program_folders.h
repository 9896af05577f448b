#pragma once

#include <filesystem>
#include <optional>

namespace loomlight {

// Where the files lie that travel with the program. They are found from the program itself, so that an installed tree
// can be moved: PREFIX/bin/loomlight has its files in PREFIX/share/loomlight. A build tree is laid out in the same way.
// What the program cannot do without (fonts, shaders, the cloths of its menu) is inside it.

/// The file that this process runs, with links followed. Empty where the system does not tell.
std::filesystem::path programFile();

/// The folder of shared files of a program at that place, whether it is there or not. Empty if `program` is.
std::filesystem::path sharedFolderOf(const std::filesystem::path& program);

/// The sample fabrics and meshes, or none where this program stands alone.
std::optional<std::filesystem::path> sampleFolder(const std::filesystem::path& program = programFile());

}  // namespace loomlight
