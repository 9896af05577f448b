#include "render/scene/embree_device.h"

#include <stdexcept>

#include "core/base/parallel.h"

namespace loomlight {
namespace {

/// What a device is told of threads. Nothing: Embree hands the number on to oneTBB as a limit for the whole program,
/// for as long as the device lives. Only in builds for ThreadSanitizer it is 1, since ThreadSanitizer cannot follow the
/// threads of oneTBB; nothing else uses oneTBB in them (core/base/parallel.h), so that the limit is Embree's alone.
#ifdef LOOMLIGHT_STD_THREADS
constexpr const char* kConfiguration = "threads=1";
#else
constexpr const char* kConfiguration = nullptr;
#endif

}  // namespace

EmbreeDevice::EmbreeDevice() : handle_(rtcNewDevice(kConfiguration)) {
  if (!handle_) throw std::runtime_error("Embree could not start");
  rtcSetDeviceMemoryMonitorFunction(
      handle_,
      [](void* user, ssize_t bytes, bool) {
        *static_cast<std::atomic<int64_t>*>(user) += bytes;
        return true;
      },
      &bytes_);
}

void EmbreeDevice::commit(RTCScene scene, int threads) const {
  withThreads(embree::builderThreads(threads), [scene] { rtcCommitScene(scene); });
}

}  // namespace loomlight
