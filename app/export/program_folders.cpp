#include "app/export/program_folders.h"

namespace loomlight {
namespace fs = std::filesystem;

fs::path programFile() {
  std::error_code error;
  fs::path file = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : file;
}

fs::path sharedFolderOf(const fs::path& program) {
  if (program.empty()) return {};
  return program.parent_path().parent_path() / "share" / "loomlight";
}

std::optional<fs::path> sampleFolder(const fs::path& program) {
  const fs::path folder = sharedFolderOf(program) / "samples";
  std::error_code error;
  if (program.empty() || !fs::is_directory(folder, error)) return std::nullopt;
  return folder;
}

}  // namespace loomlight
