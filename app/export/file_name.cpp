#include "app/export/file_name.h"

#include <fmt/core.h>

#include <string_view>

#include "core/base/text.h"
#include "core/base/utf8.h"

namespace loomlight {
namespace fs = std::filesystem;

bool isFabricFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".json" || extension == ".loomlight";
}

bool isWeavingFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".wif" || extension == ".dtx" || extension == ".txt";
}

std::string fileNameOf(const std::string& name) {
  constexpr size_t kLongest = 100;
  std::string file;
  constexpr std::string_view kRefused = "/\\:*?\"<>|";  // here or by the systems of those that a file is handed to
  for (const char c : wholeCharacters(name, kLongest))
    file += kRefused.find(c) != std::string_view::npos || static_cast<unsigned char>(c) < 32 ? '-' : c;
  while (!file.empty() && (file.front() == '.' || file.front() == ' ')) file.erase(file.begin());
  return file.empty() ? "Untitled" : file;
}

std::string portableFileName(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    plain += letter || (static_cast<unsigned char>(c) & 0x80) != 0 ? c : '_';
  }
  return plain.empty() ? "cloth" : plain;
}

bool isTaken(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

fs::path freeFile(const fs::path& wanted) {
  fs::path file = wanted;
  for (int i = 2; isTaken(file); ++i)
    file = wanted.parent_path() / fmt::format("{} {}{}", wanted.stem().string(), i, wanted.extension().string());
  return file;
}

}  // namespace loomlight
