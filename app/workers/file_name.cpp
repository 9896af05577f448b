#include "app/workers/file_name.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace loomlight {

std::string lowerExtension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace loomlight
