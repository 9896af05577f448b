#include "app/cli/interrupt.h"

#include <pthread.h>
#include <signal.h>

#include <cstdio>
#include <cstdlib>

#include "core/base/parallel.h"

namespace loomlight {
namespace {

constexpr int kDismissed = SIGUSR1;  // sent by the destructor alone

sigset_t handledSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, kDismissed}) sigaddset(&signals, signal);
  return signals;
}

// A thread that waits for the signals may do anything; a signal handler may do next to nothing.
void listen(const std::stop_source& source) {
  const sigset_t signals = handledSignals();
  for (;;) {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0 || signal == kDismissed) return;
    if (source.stop_requested()) std::_Exit(128 + signal);
    source.request_stop();
    std::fputs("\nloomlight: stopping; once more to quit at once\n", stderr);
  }
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t signals = handledSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  listener_ = std::thread(listen, source_);
}

Interrupt::~Interrupt() {
  pthread_kill(listener_.native_handle(), kDismissed);
  listener_.join();
  const sigset_t signals = handledSignals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

Task Interrupt::task(int threads) const {
  Task task;
  task.stop = token();
  task.threads = threads > 0 ? threads : hardwareThreads();
  return task;
}

}  // namespace loomlight
