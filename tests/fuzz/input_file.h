#pragma once

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace loomlight::fuzz {

/// A file for what is only read by its name: one for each process, over and over. tests/fuzz/run has its folder in
/// memory, and removes what a process leaves that a finding has ended.
class InputFile {
 public:
  /// `ending`: of its name, with the dot.
  explicit InputFile(const std::string& ending)
      : name_((std::filesystem::temp_directory_path() / ("loomlight-fuzz-" + std::to_string(getpid()) + ending))
                  .string()) {}
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& holding(std::string_view bytes) const {
    std::ofstream(name_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return name_;
  }

 private:
  std::string name_;
};

}  // namespace loomlight::fuzz
