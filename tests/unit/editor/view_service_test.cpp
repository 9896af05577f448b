#include "app/editor/services/view_service.h"

#include <gtest/gtest.h>

#include "tests/support/memory_driver.h"
#include "tests/support/test_cloth.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

TEST(ViewService, IsOpeningUntilThereIsAPictureAtFullResolution) {
  MemoryDriver driver;
  Wakes wakes;
  ViewService service(driver, wakes.callback(), 2);
  EXPECT_TRUE(service.isOpening());
  ViewState state;
  state.fabric = std::make_shared<const Fabric>(test::whiteCotton());
  state.width = 64;
  state.height = 48;
  service.follow(state);
  ASSERT_TRUE(wakes.until([&] {
    service.take(false);
    const auto& frame = service.frame();
    return frame && frame->divider == 1 && (frame->shared || frame->samples > 0);
  }));
  EXPECT_FALSE(service.isOpening());

  service.open();
  EXPECT_TRUE(service.isOpening());
  service.pause(ViewService::Rival::presets, true);
  EXPECT_FALSE(service.isOpening()) << "nothing is traced that others could hold up";
}

}  // namespace
}  // namespace loomlight
