#include "app/bench/clear_course.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/bench/clear_settings.h"
#include "core/fabric/model/changes.h"
#include "core/fabric/model/validate.h"

namespace loomlight {
namespace {

TEST(ClearCourse, TellsWhatIsShownAndWhenItIsClear) {
  const ClearCourse course{{{0.1, 0.4, 0}, {0.5, 0.09, 0}, {1.0, 0.12, 1}, {2.0, 0.04, 2}}};
  EXPECT_EQ(course.first(), 0.4);
  EXPECT_EQ(course.at(0.05), 1.0);
  EXPECT_EQ(course.at(0.7), 0.09);
  EXPECT_EQ(course.at(10), 0.04);
  EXPECT_EQ(course.timeTo(0.10), 0.5);
  EXPECT_EQ(course.timeTo(0.05), 2.0);
  EXPECT_TRUE(std::isinf(course.timeTo(0.03)));
  EXPECT_NEAR(course.worstStepBack(), 0.12 / 0.09, 1e-9);
}

TEST(ClearCourse, OfNothingIsFarFromAll) {
  const ClearCourse none;
  EXPECT_EQ(none.first(), 1.0);
  EXPECT_EQ(none.at(1), 1.0);
  EXPECT_EQ(none.worstStepBack(), 1.0);
}

TEST(ClearSettings, ANameChoosesAmongItsOwnKindAlone) {
  const ClearChoice all{}, denim{{"denim"}}, foldedDenim{{"denim", "folds", "light"}};
  EXPECT_EQ(clearSettings(all, false).size(), 6u * 4u * 3u);
  EXPECT_EQ(clearSettings(denim, false).size(), 4u * 3u);
  EXPECT_EQ(clearSettings(foldedDenim, false).size(), 3u);
  EXPECT_EQ(clearSettings(all, true).size(), 1u);
  EXPECT_EQ(clearEdits(denim).size(), clearEdits(all).size());
  ASSERT_EQ(clearEdits(foldedDenim).size(), 1u);
  EXPECT_EQ(clearEdits(foldedDenim).front().name, "light");
}

TEST(ClearSettings, EveryEditOfEverySettingIsAnEdit) {
  for (const ClearSetting& setting : clearSettings({}, false))
    for (const ClearEdit& edit : clearEdits({})) {
      const Fabric edited = edit.apply(setting.fabric);
      EXPECT_NO_THROW(validate(edited, setting.name()));
      EXPECT_EQ(changes(setting.fabric, edited).picture(), edit.name != "open") << setting.name() << edit.name;
    }
}

TEST(ClearEdits, ADragTurnsTheCameraStepByStep) {
  const std::vector<ClearEdit> drags = clearEdits({{"drag"}});
  ASSERT_EQ(drags.size(), 1u);
  Fabric before;
  const std::vector<Fabric> steps = drags.front().steps(before);
  EXPECT_EQ(steps.size(), 20u);
  for (const Fabric& step : steps) {
    EXPECT_NEAR(step.camera.azimuth_deg, before.camera.azimuth_deg + 2, 1e-9);
    before = step;
  }
}

}  // namespace
}  // namespace loomlight
