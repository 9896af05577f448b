#pragma once

#include <string>

namespace loomlight {

/// A name that is not taken yet: the wish, or that with another number. Numbers do not pile up: after "cotton 2" comes
/// "cotton 3".
template <class IsTaken>
std::string freshName(const std::string& wish, const IsTaken& isTaken) {
  const size_t end = wish.find_last_not_of("0123456789");
  const bool isNumbered = end != std::string::npos && end > 0 && end + 1 < wish.size() && wish[end] == ' ';
  const std::string stem = isNumbered ? wish.substr(0, end) : wish;
  std::string name = wish;
  for (int i = 2; isTaken(name); ++i) name = stem + " " + std::to_string(i);
  return name;
}

}  // namespace loomlight
