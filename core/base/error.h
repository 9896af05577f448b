#pragma once

#include <stdexcept>
#include <string>

namespace loomlight {

/// The user's input is wrong: a file, a number, an option. The message is for the user and names the file, the place
/// in it, and what was expected. Thrown below `app`, shown by it; never used for our own bugs (those assert).
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace loomlight
