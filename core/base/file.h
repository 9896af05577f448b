#pragma once

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>

namespace loomlight {

/// The whole content of a regular file. Throws InputError if there is none, if it cannot be read, if it is something
/// else (a folder, a pipe), or if it is larger than `maxBytes`.
std::string readFile(const std::string& file, size_t maxBytes);

/// Throws InputError where writeFileAtomically() could not write: no such folder, no right to write into it, or
/// something that is no regular file in its place. Called before long work, so that a slip in a name costs nothing.
void expectWritable(const std::string& file);

/// The file that is replaced where this one is to be written: a symbolic link is followed.
std::filesystem::path replacedBy(const std::string& file);

/// Brings the folder of a file to the disk, without which a rename is not safe from a power cut. Some file systems
/// cannot sync folders; the file's own bytes are safe there already.
void syncFolder(const std::filesystem::path& file);

/// Replaces a file's content, or makes the file: writes beside it, waits until the bytes are on the disk, then renames.
/// Whenever it is interrupted, the file is whole or the old one is still there. Throws InputError, and leaves nothing
/// behind, when it cannot be written; what is no regular file (a folder, a pipe, a device) is never replaced. False
/// where a stop was requested while the old one was still there, and is.
bool writeFileAtomically(const std::string& file, std::string_view content, const std::stop_token& stop = {});

}  // namespace loomlight
