#include "app/export/file_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "core/base/text.h"
#include "core/base/utf8.h"

namespace loomlight {
namespace fs = std::filesystem;

namespace {

/// Bytes, so that a few dozen may be added behind it in any file system.
constexpr size_t kLongest = 100;

/// Names of devices on Windows, whatever stands behind a dot: no file there can be called so.
bool isReserved(const std::string& name) {
  const std::string stem = lowerCase(name.substr(0, name.find('.')));
  if (stem == "con" || stem == "prn" || stem == "aux" || stem == "nul") return true;
  const bool isPort = stem.size() == 4 && (stem.rfind("com", 0) == 0 || stem.rfind("lpt", 0) == 0);
  return isPort && stem[3] >= '1' && stem[3] <= '9';
}

}  // namespace

bool isFabricFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".json" || extension == ".loomlight";
}

bool isWeavingFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".wif" || extension == ".plm" || extension == ".dtx" || extension == ".twa" ||
         extension == ".txt";
}

std::optional<std::string> programOfForeignDraft(const std::string& file) {
  const std::string extension = lowerExtension(file);
  if (extension == ".wpo") return "WeavePoint";
  return std::nullopt;
}

std::string fileNameOf(const std::string& name) {
  std::string file;
  constexpr std::string_view kRefused = "/\\:*?\"<>|";  // here or by the systems of those that a file is handed to
  for (const char c : wholeCharacters(name, kLongest))
    file += kRefused.find(c) != std::string_view::npos || static_cast<unsigned char>(c) < 32 ? '-' : c;
  while (!file.empty() && (file.front() == '.' || file.front() == ' ')) file.erase(file.begin());
  if (isReserved(file)) file.insert(std::min(file.find('.'), file.size()), 1, '_');
  return file.empty() ? "Untitled" : file;
}

std::string portableFileName(const std::string& name) {
  std::string plain;
  for (const char c : wholeCharacters(name, kLongest)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    plain += letter || (static_cast<unsigned char>(c) & 0x80) != 0 ? c : '_';
  }
  if (isReserved(plain)) plain += '_';
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
