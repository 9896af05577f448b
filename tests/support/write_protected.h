#pragma once

#include <gtest/gtest.h>

#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <system_error>
#include <utility>

namespace loomlight::test {

/// Acts as somebody whom a file can be protected from: on a thread that gives up root's right to pass over permissions,
/// as have the threads that it begins. A thread that has given it up cannot have it back.
inline void humbly(const std::function<void()>& act) {
  std::async(std::launch::async, [&] {
    __user_cap_header_struct thisThread{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct rights[_LINUX_CAPABILITY_U32S_3]{};
    EXPECT_EQ(syscall(SYS_capget, &thisThread, rights), 0);
    constexpr uint32_t kPassOver = 1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH;
    rights[0].effective &= ~kPassOver;
    rights[0].permitted &= ~kPassOver;
    EXPECT_EQ(syscall(SYS_capset, &thisThread, rights), 0);
    act();
  }).get();
}

/// A file or a folder that nobody may write for as long as this lives; root may all the same, unless acting humbly().
class WriteProtected {
 public:
  explicit WriteProtected(std::filesystem::path place) : place_(std::move(place)) {
    std::filesystem::permissions(place_, kWriting, std::filesystem::perm_options::remove);
  }
  ~WriteProtected() {
    std::error_code gone;
    std::filesystem::permissions(place_, std::filesystem::perms::owner_write, std::filesystem::perm_options::add, gone);
  }
  WriteProtected(const WriteProtected&) = delete;
  WriteProtected& operator=(const WriteProtected&) = delete;

 private:
  static constexpr auto kWriting =
      std::filesystem::perms::owner_write | std::filesystem::perms::group_write | std::filesystem::perms::others_write;
  const std::filesystem::path place_;
};

}  // namespace loomlight::test
