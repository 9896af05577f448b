#pragma once

#include <stdexcept>
#include <string>

namespace loomlight {

/// The command line is wrong: an option that does not exist, a value out of its range. The message names the option and
/// what was expected. Exit status 2.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace loomlight
