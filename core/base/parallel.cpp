#include "core/base/parallel.h"

#include <algorithm>
#include <thread>

#ifdef LOOMLIGHT_STD_THREADS
#include <atomic>
#include <exception>
#include <mutex>
#include <vector>
#else
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace loomlight {

int hardwareThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallelFor(size_t count, int threads, const std::function<void(size_t)>& body) {
  if (threads <= 0) threads = hardwareThreads();
  if (threads == 1 || count <= 1) {
    for (size_t i = 0; i < count; ++i) body(i);
    return;
  }
#ifdef LOOMLIGHT_STD_THREADS
  std::atomic<size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  auto work = [&] {
    try {
      for (size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int t = 1; t < threads; ++t) workers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
#else
  // More threads than cores is a fair wish (tests compare three on a machine of two), but oneTBB needs to be told.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(std::max(threads, hardwareThreads())));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, 1),
        [&](const tbb::blocked_range<size_t>& range) {
          for (size_t i = range.begin(); i != range.end(); ++i) body(i);
        },
        tbb::simple_partitioner());
  });
#endif
}

void withThreads([[maybe_unused]] int threads, const std::function<void()>& body) {
#ifdef LOOMLIGHT_STD_THREADS
  body();
#else
  tbb::task_arena(threads > 0 ? threads : hardwareThreads()).execute(body);
#endif
}

}  // namespace loomlight
