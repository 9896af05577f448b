#pragma once

#include <cstdint>

namespace loomlight {

/// The machine's memory in bytes; the largest number there is where the system does not tell.
uint64_t physicalMemory_bytes();

/// Hands to the system what the allocator holds back for later of all that was freed; else a program keeps the most
/// that it ever took. Some milliseconds for each 100 MB; nothing where the allocator cannot.
void releaseFreeMemory();

}  // namespace loomlight
