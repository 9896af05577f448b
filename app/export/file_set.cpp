#include "app/export/file_set.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"

namespace loomlight {
namespace fs = std::filesystem;

namespace {

void makeFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw InputError(fmt::format("{}: expected a folder that can be made, got: {}", folder.string(), failed.message()));
}

}  // namespace

FileSet::FileSet(const std::string& folder, const std::string& name) : folder_(folder.empty() ? "." : folder) {
  scratch_ = (fs::path(folder_) / fmt::format(".{}.unfinished", name)).string();
  std::error_code none;
  fs::remove_all(scratch_, none);
  makeFolder(scratch_);
}

FileSet::~FileSet() {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

std::string FileSet::add(const std::string& name) {
  makeFolder(fs::path(pathOf(name)).parent_path());
  names_.push_back(name);
  return pathOf(name);
}

void FileSet::place() const {
  for (const std::string& name : names_) {
    const fs::path to = fs::path(folder_) / name;
    makeFolder(to.parent_path());
    expectWritable(to.string());
  }
  for (const std::string& name : names_) {
    const fs::path to = fs::path(folder_) / name;
    std::error_code failed;
    fs::rename(fs::path(scratch_) / name, to, failed);
    if (failed) throw InputError(fmt::format("{}: cannot be put in its place: {}", to.string(), failed.message()));
  }
}

}  // namespace loomlight
