#include <gtest/gtest.h>

#include <string>

#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/lamp_name.h"
#include "ui/widgets/choices.h"

namespace loomlight {
namespace {

/// What a list says of a lamp begins with the name by which options and files know it.
TEST(LampLabels, BeginWithTheNameOfTheLamp) {
  for (size_t i = 0; i < ChoiceNames<StandardIlluminant>::names.size(); ++i) {
    const auto lamp = static_cast<StandardIlluminant>(i);
    if (lamp == StandardIlluminant::blackBody || lamp == StandardIlluminant::file) continue;
    EXPECT_TRUE(std::string(lampLabel(lamp)).starts_with(lampName({lamp}) + ",")) << lampLabel(lamp);
    EXPECT_EQ(lampWord(lamp), lampName({lamp}));
  }
}

}  // namespace
}  // namespace loomlight
