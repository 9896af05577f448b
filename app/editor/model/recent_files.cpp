#include "app/editor/model/recent_files.h"

#include <algorithm>
#include <filesystem>

namespace loomlight {

void forget(std::vector<RecentFile>& files, const std::string& file) {
  files.erase(std::remove_if(files.begin(), files.end(), [&](const RecentFile& f) { return f.file == file; }),
              files.end());
}

void remember(std::vector<RecentFile>& files, const std::string& file) {
  forget(files, file);
  files.insert(files.begin(), {file, false});
  if (files.size() > kMostRecentFiles) files.resize(kMostRecentFiles);
}

void lookFor(std::vector<RecentFile>& files) {
  for (RecentFile& file : files) {
    std::error_code ignored;
    file.missing = !std::filesystem::is_regular_file(file.file, ignored);
  }
}

}  // namespace loomlight
