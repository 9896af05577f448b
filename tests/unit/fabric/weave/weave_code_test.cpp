#include "core/fabric/weave/weave_code.h"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "core/fabric/weave/structures.h"

namespace loomlight {
namespace {

std::vector<int> numbersOf(const std::string& part) {
  std::istringstream in(part);
  std::vector<int> numbers;
  for (int number = 0; in >> number;) numbers.push_back(number);
  return numbers;
}

/// What a code says, end by end, over `ends` ends: written from the standard's words, not from ours.
Weave wovenBy(const std::string& code, int ends) {
  std::vector<std::vector<int>> parts;
  std::istringstream in(code);
  for (std::string part; std::getline(in, part, '-');) parts.push_back(numbersOf(part));
  std::vector<uint8_t> first;
  uint8_t up = parts[0][0] % 10 == 0;
  for (const int run : parts[1]) {
    first.insert(first.end(), static_cast<size_t>(run), up);
    up = !up;
  }
  const int picks = static_cast<int>(first.size()), step = parts[3][0];
  std::vector<std::vector<uint8_t>> rows(static_cast<size_t>(picks), std::vector<uint8_t>(static_cast<size_t>(ends)));
  int end = 0;
  for (int group = 0; end < ends; ++group) {
    const int width = parts[2][static_cast<size_t>(group) % parts[2].size()];
    for (int i = 0; i < width && end < ends; ++i, ++end)
      for (int pick = 0; pick < picks; ++pick) {
        const int from = ((pick - step * group) % picks + picks) % picks;
        const bool inverted = step == 0 && group % 2 == 1;
        rows[static_cast<size_t>(pick)][static_cast<size_t>(end)] = first[static_cast<size_t>(from)] != inverted;
      }
  }
  return Weave(rows);
}

/// Equal but for the pick that counts as the first.
bool sameCloth(const Weave& a, const Weave& b) {
  if (a.ends() != b.ends() || a.picks() != b.picks()) return false;
  for (int shift = 0; shift < a.picks(); ++shift) {
    bool same = true;
    for (int pick = 0; pick < a.picks() && same; ++pick)
      for (int end = 0; end < a.ends() && same; ++end) same = a.at(pick, end) == b.at((pick + shift) % a.picks(), end);
    if (same) return true;
  }
  return false;
}

TEST(WeaveCode, NamesTheBasicWeaves) {
  EXPECT_EQ(isoWeaveCode(plainWeave()), "10-01 01-01-00");
  EXPECT_EQ(isoWeaveCode(basket(2, 2)), "10-02 02-02-00");
  EXPECT_EQ(isoWeaveCode(basket(1, 2)), "10-02 02-01-00");
  EXPECT_EQ(isoWeaveCode(basket(2, 1)), "10-01 01-02-00");
  EXPECT_EQ(isoWeaveCode(twill(2, 2)), "20-02 02-01-01");
  EXPECT_EQ(isoWeaveCode(twill(3, 1, Slant::s)), "20-03 01-01-03");
  EXPECT_EQ(isoWeaveCode(twill({2, 2, 1, 3}, 1, Slant::z)), "20-02 02 01 03-01-01");
  EXPECT_EQ(isoWeaveCode(Weave({{1, 1, 0, 1, 0, 0}, {0, 0, 1, 0, 1, 1}})), "10-01 01-02 01 01 02-00");
}

TEST(WeaveCode, SaysTheCloth) {
  std::vector<Weave> weaves = {plainWeave(), basket(3, 2), basket(1, 4), twill(1, 2), twill({3, 1, 1, 2}, 2, Slant::s)};
  for (const int ends : {5, 7, 8, 12})
    for (const int step : satinSteps(ends))
      for (const Face face : {Face::warp, Face::weft}) weaves.push_back(satin(ends, step, face));
  for (const Weave& weave : weaves) {
    const auto code = isoWeaveCode(weave);
    ASSERT_TRUE(code.has_value());
    EXPECT_TRUE(sameCloth(wovenBy(*code, weave.ends()), weave)) << *code;
  }
}

TEST(WeaveCode, IsOfTheSmallestRepeat) {
  for (const Weave& weave : {plainWeave(), basket(2, 3), twill(2, 2), twill(3, 1, Slant::s), satin(5, 2)})
    EXPECT_EQ(isoWeaveCode(weave.resized(3 * weave.ends(), 2 * weave.picks())), isoWeaveCode(weave));
  EXPECT_EQ(
      isoWeaveCode(Weave(std::vector<std::vector<uint8_t>>{{1, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 1, 0}, {0, 1, 1, 0}})),
      "10-02 02-02-00")
      << "begins within a group";
}

TEST(WeaveCode, KnowsSatinsFromTwills) {
  for (const int step : satinSteps(8)) EXPECT_EQ(isoWeaveCode(satin(8, step))->front(), '3');
  EXPECT_EQ(isoWeaveCode(twill(7, 1))->front(), '2');
}

TEST(WeaveCode, IsNoneForOtherWeaves) {
  for (const Weave& weave :
       {herringbone(2, 8), waffle(5), diamondTwill(2, 2), plainWeave().resized(1, 1), plainWeave().resized(2, 1)})
    EXPECT_EQ(isoWeaveCode(weave), std::nullopt);
  EXPECT_EQ(isoWeaveCode(twill(60, 60)), std::nullopt) << "two digits a number";
}

}  // namespace
}  // namespace loomlight
