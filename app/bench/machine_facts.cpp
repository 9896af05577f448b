#include "app/bench/machine_facts.h"

#include <fmt/format.h>

#include <fstream>

#include "core/base/memory.h"
#include "core/base/parallel.h"

namespace loomlight {
namespace {

/// As Linux names it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) {
      const size_t colon = line.find(": ");
      if (colon != std::string::npos) return line.substr(colon + 2);
    }
  return "unknown processor";
}

}  // namespace

std::string machineFacts(int threads) {
  return fmt::format("{}, {} hardware threads, {} at work, {:.0f} GB of memory; Loomlight {}, compiler {}.",
                     processor(), hardwareThreads(), threads, static_cast<double>(physicalMemory_bytes()) / 1e9,
                     LOOMLIGHT_VERSION, __VERSION__);
}

}  // namespace loomlight
