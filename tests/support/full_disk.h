#pragma once

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/resource.h>

namespace loomlight::test {

/// A disk that is full, as far as this process can tell: no file may have more bytes than these, for as long as it
/// lives.
class FullDisk {
 public:
  static constexpr rlim_t kFewerThanAnyFile = 2;  ///< bytes: of those that the editor writes
  explicit FullDisk(rlim_t mayHave_bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{mayHave_bytes, before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  decltype(signal(0, nullptr)) handler_;
  rlimit before_{};
};

}  // namespace loomlight::test
