#pragma once

#include <array>
#include <cstdint>

#include "core/base/hash.h"
#include "core/base/units.h"

namespace loomlight {

/// Threads of one yarn are dyed more or less deeply, in a few classes. Which class a thread has is chance.
inline constexpr int kShadeClasses = 8;

inline int shadeClass(System system, int thread) {
  constexpr uint64_t kSalt = 0x5AADE;
  return static_cast<int>(mixBits(hashCombine(kSalt + static_cast<uint64_t>(system), thread)) % kShadeClasses);
}

/// Factor on the absorption of a thread's fibres. `variation`: coefficient of variation, 0..0.4. The mean over the
/// classes is 1; they are the middles of eight equal parts of a normal distribution, spread to its variance.
inline float shadeFactor(float variation, int shadeClass) {
  constexpr std::array<float, kShadeClasses> kDeviations = {-1.6630f, -0.9622f, -0.5300f, -0.1706f,
                                                            0.1706f,  0.5300f,  0.9622f,  1.6630f};
  return 1 + variation * kDeviations[static_cast<size_t>(shadeClass)];
}

}  // namespace loomlight
