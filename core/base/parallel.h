#pragma once

#include <cstddef>
#include <functional>

namespace loomlight {

/// Number of hardware threads, at least 1.
int hardwareThreads();

/// Calls body(i) once for every i in [0, count), on up to `threads` threads (0: all), in no fixed order; returns when
/// all have returned. The first exception is rethrown. This is the only place where the program meets a scheduler:
/// oneTBB arenas, or plain std::thread in ThreadSanitizer builds, because Debian's oneTBB is not instrumented.
/// Cost: one indirect call an index; give it tiles, bricks or rows, not pixels.
void parallelFor(size_t count, int threads, const std::function<void(size_t)>& body);

/// Calls `body`, in which a library that brings its work to oneTBB by itself finds up to `threads` threads (0: all). In
/// builds for ThreadSanitizer it just calls it.
void withThreads(int threads, const std::function<void()>& body);

}  // namespace loomlight
