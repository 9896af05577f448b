#pragma once

#include <string>

namespace loomlight::test {

/// The JSON of a fabric that says nothing but this: `"key": value`.
inline std::string fabricWith(const std::string& entry) {
  return "{\"loomlight_version\": 1, " + entry + "}";
}

}  // namespace loomlight::test
