#include "app/live/mailbox.h"

#include <gtest/gtest.h>

#include <memory>

namespace loomlight {
namespace {

TEST(Mailbox, HandsOverTheNewestOnce) {
  Mailbox<int> box;
  EXPECT_FALSE(box.waiting());
  box.post(1);
  box.post(2);
  EXPECT_TRUE(box.waiting());
  EXPECT_EQ(box.take(), 2);
  EXPECT_FALSE(box.waiting());
  EXPECT_EQ(box.take(), std::nullopt);
}

TEST(Mailbox, WaitingEndsWhenStopped) {
  Mailbox<int> box;
  std::stop_source stop;
  box.post(1);
  EXPECT_EQ(box.wait(stop.get_token()), 1);
  stop.request_stop();
  EXPECT_EQ(box.wait(stop.get_token()), std::nullopt);
}

// Freeing a scene takes a while; nobody who only asks may wait for it.
TEST(Mailbox, IsOpenWhileWhatItDropsDies) {
  Mailbox<std::shared_ptr<void>> box;
  bool died = false, sawTheNewOne = false;
  box.post(std::shared_ptr<void>(nullptr, [&](void*) {
    died = true;
    sawTheNewOne = box.waiting();
  }));
  box.post(nullptr);
  EXPECT_TRUE(died);
  EXPECT_TRUE(sawTheNewOne);
}

}  // namespace
}  // namespace loomlight
