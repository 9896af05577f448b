#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/base/error.h"

namespace loomlight::fuzz {

/// The program does what it never should, whatever it is given.
class Finding : public std::logic_error {
 public:
  explicit Finding(const std::string& what) : std::logic_error(what) {}
};

inline void expect(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

/// Whether `read` reads the file of this name. It may refuse it, by a message that names it and that any terminal
/// shows; any other exception is a finding.
template <class Read>
bool isRead(const std::string& name, const Read& read) {
  constexpr size_t kLongest = 2000;
  try {
    read();
    return true;
  } catch (const InputError& error) {
    const std::string said = error.what();
    const auto shows = [](char c) { return c >= 0x20 && c < 0x7F; };
    expect(said.find(name) != std::string::npos, "a message does not name the file: " + said);
    expect(std::all_of(said.begin(), said.end(), shows), "a message holds what no terminal shows: " + said);
    expect(said.size() < kLongest, fmt::format("a message has {} bytes", said.size()));
    return false;
  }
}

}  // namespace loomlight::fuzz
