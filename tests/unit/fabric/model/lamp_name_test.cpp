#include "core/fabric/model/lamp_name.h"

#include <gtest/gtest.h>

#include "core/fabric/model/choice_names.h"

namespace loomlight {
namespace {

using enum StandardIlluminant;

TEST(LampName, IsReadAsItIsWritten) {
  for (const StandardIlluminant lamp : {d65, d55, d50, a, e, f2, f7, f11, ledB1, ledB2, ledB3, ledB4, ledB5})
    EXPECT_EQ(lampFromName(lampName({lamp})), NamedLamp{lamp}) << lampName({lamp});
  for (const double kelvin : {1000.0, 2856.0, 6504.5})
    EXPECT_EQ(lampFromName(lampName({blackBody, kelvin})), (NamedLamp{blackBody, kelvin}));
  EXPECT_EQ(lampName({ledB3}), "LED-B3");
  EXPECT_EQ(lampName({blackBody, 2856}), "2856 K");
  EXPECT_EQ(lampNames().size(), ChoiceNames<StandardIlluminant>::names.size() - 2) << "all but black bodies and files";
}

TEST(LampName, IsReadAsOthersWriteIt) {
  for (const char* name : {"LED-B3", "led-b3", "led_b3", "LED B3"})
    EXPECT_EQ(lampFromName(name), NamedLamp{ledB3}) << name;
  for (const char* name : {"F11", "fl11", "FL11", "TL84", "tl84"})
    EXPECT_EQ(lampFromName(name), NamedLamp{f11}) << name;
  for (const char* name : {"2856 K", "2856K", "2856k", "2856 k", "2856.0K"})
    EXPECT_EQ(lampFromName(name), (NamedLamp{blackBody, 2856})) << name;
}

/// As files had it from the first on: what a fabric says of its lamp is a name like any other.
TEST(LampName, OfAChoiceInAFileIsOne) {
  for (const char* name : ChoiceNames<StandardIlluminant>::names) {
    const StandardIlluminant meant = *choiceFromName<StandardIlluminant>(name);
    const bool saysWhich = meant != blackBody && meant != file;
    EXPECT_EQ(lampFromName(name), saysWhich ? std::optional(NamedLamp{meant}) : std::nullopt) << name;
  }
}

TEST(LampName, OfNoLampIsNone) {
  for (const char* name : {"", "D66", "F3", "FL", "fluorescent", "LED", "K", "-5 K", "0 K", "nan K", "inf K", "2856",
                           "2856  K", "2856 kelvin", "lamp.txt", "black_body", "file"})
    EXPECT_FALSE(lampFromName(name)) << name;
}

}  // namespace
}  // namespace loomlight
