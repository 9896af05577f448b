#pragma once

#include <cstring>
#include <string>

#include "core/base/random.h"

namespace loomlight::test {

/// A file that somebody's disk, mail or malice has been at: bits turned, bytes and numbers replaced, pieces cut out,
/// said twice, or put elsewhere, the end cut off.
inline std::string mutated(std::string bytes, Random& random) {
  const auto place = [&] { return random.below(static_cast<uint32_t>(bytes.size())); };
  for (uint32_t changes = 1 + random.below(4); changes > 0 && !bytes.empty(); --changes) {
    const uint32_t at = place();
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << random.below(8));
        break;
      case 1:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 2: {  // a number that is too large for whatever it counts
        constexpr uint32_t kNumbers[] = {0, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x00010000, 0x7F800000};
        const uint32_t number = kNumbers[random.below(6)];
        if (at + sizeof(number) <= bytes.size()) std::memcpy(bytes.data() + at, &number, sizeof(number));
        break;
      }
      case 3:
        bytes.erase(at, 1 + random.below(40));
        break;
      case 4:
        bytes.insert(at, bytes.substr(place(), 1 + random.below(60)));
        break;
      default:
        bytes.resize(at);
    }
  }
  return bytes;
}

}  // namespace loomlight::test
