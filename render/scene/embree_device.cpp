#include "render/scene/embree_device.h"

#include <fmt/format.h>

#include <stdexcept>

namespace loomlight {
namespace {

/// Embree's threads are oneTBB's, which ThreadSanitizer cannot follow (core/base/parallel.h). And where Embree 4 is
/// told to stop, it throws out of a task, which another thread may have taken by then: now and then that one ends the
/// program in TBB (seen with Embree 4.3 and oneTBB 2022, not with Embree 3.13 and 2021). One thread has nobody to take
/// its tasks.
int builderThreads([[maybe_unused]] int threads) {
#if defined(LOOMLIGHT_STD_THREADS) || LOOMLIGHT_EMBREE_MAJOR >= 4
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
