#pragma once

#include <string>

namespace loomlight {

/// What times are measured on: processor, threads that worked, memory, compiler. One sentence.
std::string machineFacts(int threads);

}  // namespace loomlight
