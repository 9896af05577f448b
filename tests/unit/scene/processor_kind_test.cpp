#include "render/scene/processor_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loomlight {
namespace {

// That processors which round otherwise are of other kinds is for tests/e2e/command_line/processor_test.py.
TEST(ProcessorKind, IsTheSameWheneverItIsAskedFor) {
  const std::string kind = processorKind();
  EXPECT_THAT(kind, testing::MatchesRegex("[0-9a-f]{16}"));
  EXPECT_EQ(processorKind(), kind);
}

}  // namespace
}  // namespace loomlight
