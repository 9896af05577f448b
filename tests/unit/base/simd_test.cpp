#include "core/base/simd.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/random_lanes.h"

namespace loomlight {
namespace {

TEST(Simd, BroadcastKeepsEveryNumberToTheBit) {
  for (const float x : {0.0f, -0.0f, 1e-40f, -3.25f, 1e30f})
    for (int lane = 0; lane < 8; ++lane)
      EXPECT_EQ(std::bit_cast<uint32_t>(static_cast<float>(broadcast<Float32x8>(x)[lane])), std::bit_cast<uint32_t>(x));
}

TEST(Simd, SignIsThatOfAZeroToo) {
  const Float32x8 signs = signOf(Float32x8{0.0f, -0.0f, 5, -5, 1e-40f, -1e-40f, 1e30f, -1e30f});
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(signs[lane], lane % 2 == 0 ? 1 : -1) << lane;
  EXPECT_EQ(signOf(-0.0f), -1);
}

TEST(Simd, TransposedHasTheRowsAsColumns) {
  std::array<Float32x4, 8> rows;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 4; ++column)
      rows[static_cast<size_t>(row)][column] = static_cast<float>(10 * row + column);
  const std::array<Float32x8, 4> columns = transposed(rows);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 4; ++column) EXPECT_EQ(columns[static_cast<size_t>(column)][row], 10 * row + column);
}

TEST(Simd, GatheredAreTheNumbersAtThesePlaces) {
  std::array<float, 100> numbers;
  std::iota(numbers.begin(), numbers.end(), 0.0f);
  const Int32x8 places{99, 0, 7, 7, 50, 3, 98, 1};
  const Float32x8 found = gathered(numbers.data(), places);
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(found[lane], places[lane]);
}

TEST(RandomLanes, EachDrawsItsOwnNumbersAndOnlyWhereItIsAsked) {
  std::vector<Random> own;
  for (uint64_t lane = 0; lane < 8; ++lane) own.emplace_back(lane);
  std::vector<Random> alone = own;
  RandomLanes<Float32x8> numbers(
      std::array<Random*, 8>{&own[0], &own[1], nullptr, &own[3], &own[4], &own[5], &own[6], &own[7]});
  Int32x8 mask = ~Int32x8{};
  mask[4] = 0;
  const Float32x8 first = numbers.uniform(mask), second = numbers.uniform();
  for (size_t lane = 0; lane < 8; ++lane) {
    EXPECT_EQ(first[lane], lane == 2 || lane == 4 ? 0.0f : alone[lane].uniform()) << lane;
    EXPECT_EQ(second[lane], lane == 2 ? 0.0f : alone[lane].uniform()) << lane;
  }
}

}  // namespace
}  // namespace loomlight
