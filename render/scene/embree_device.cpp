#include "render/scene/embree_device.h"

#include <fmt/format.h>

#include <stdexcept>

namespace loomlight {
namespace {

/// Embree's threads are oneTBB's, which ThreadSanitizer cannot follow (core/base/parallel.h).
int builderThreads([[maybe_unused]] int threads) {
#ifdef LOOMLIGHT_STD_THREADS
  return 1;
#else
  return threads;
#endif
}

}  // namespace

EmbreeDevice::EmbreeDevice(int threads)
    : handle_(rtcNewDevice(fmt::format("threads={}", builderThreads(threads)).c_str())) {
  if (!handle_) throw std::runtime_error("Embree could not start");
  rtcSetDeviceMemoryMonitorFunction(
      handle_,
      [](void* user, ssize_t bytes, bool) {
        *static_cast<std::atomic<int64_t>*>(user) += bytes;
        return true;
      },
      &bytes_);
}

}  // namespace loomlight
