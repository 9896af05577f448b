#pragma once

#include <cstdint>

namespace loomlight {

/// The machine's memory in bytes; the largest number there is where the system does not tell.
uint64_t physicalMemory_bytes();

}  // namespace loomlight
