#pragma once

#include <chrono>
#include <span>
#include <string>

namespace loomlight {

/// A file of an archive: its path within, in UTF-8 with "/", and its bytes.
struct ArchivedFile {
  std::string path;
  std::string content;
};

/// An archive as .u3ma (U3M 1.1) has it, a strict part of ZIP: stored, not deflated, as pictures are packed already;
/// names in UTF-8, times in UTC, and none of the extra fields, comments, attributes and flags that libraries for ZIP
/// add. Throws InputError, naming `name`, where it would take more than the 4 GB, or the 65535 files, that it allows.
std::string restrictedZip(std::span<const ArchivedFile> files, std::chrono::sys_seconds time, const std::string& name);

}  // namespace loomlight
