#include "core/fabric/weave/yarn_order.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <span>

#include "core/base/error.h"
#include "core/fabric/weave/yarn_sequence.h"
#include "core/fabric/yarn/yarn_name.h"

// How it works. An order is a list of runs (4A) and groups (3(4A 2B)), read by recursive descent: a group is written
// out where its bracket closes, and what would be too long is refused before it takes memory. Yarns are lettered
// like columns of a spreadsheet: A to Z, then AA. An order is written from the left: the group of up to 64 runs that
// leaves least to be written comes next, its inside likewise; where none repeats, one run. That text need not be the
// shortest, but reads back as the same order. Cost: for each run, up to 64 comparisons of what follows.

namespace loomlight {
namespace {

/// Runs and groups of runs, read from the left.
class OrderReader {
 public:
  OrderReader(std::string_view text, int yarnCount, size_t most)
      : at_(text.data()), end_(text.data() + text.size()), yarnCount_(yarnCount), most_(most) {}

  std::vector<int> read() {
    std::vector<int> sequence = group(0);
    if (at_ != end_) throw InputError("expected as many ( as )");
    if (sequence.empty()) throw InputError(kExpected);
    return sequence;
  }

 private:
  static constexpr const char* kExpected = "expected threads such as 4A 2B: how many, then the yarn's letter";

  /// Up to the end, or the bracket that closes it.
  std::vector<int> group(int depth) {
    constexpr int kDeepest = 8;
    if (depth > kDeepest) throw InputError(fmt::format("expected at most {} brackets within each other", kDeepest));
    std::vector<int> sequence;
    for (skipBlanks(); at_ != end_ && *at_ != ')'; skipBlanks()) {
      const size_t count = number();
      std::vector<int> part;
      if (at_ != end_ && *at_ == '(') {
        ++at_;
        part = group(depth + 1);
        if (at_ == end_) throw InputError("expected as many ( as )");
        ++at_;
        if (part.empty()) throw InputError(kExpected);
      } else {
        part = {yarn()};
      }
      if (count * part.size() > most_ - sequence.size())
        throw InputError(fmt::format("expected at most {} threads", most_));
      for (size_t i = 0; i < count; ++i) sequence.insert(sequence.end(), part.begin(), part.end());
    }
    return sequence;
  }

  /// How often; 1 where nothing is said.
  size_t number() {
    if (!std::isdigit(static_cast<unsigned char>(*at_))) return 1;
    int count = 0;
    const auto [next, error] = std::from_chars(at_, end_, count);
    if (error != std::errc() || count < 1)
      throw InputError(fmt::format("expected a number from 1 to {} before a yarn's letter", most_));
    at_ = next;
    skipBlanks();
    return static_cast<size_t>(count);
  }

  int yarn() {
    int yarn = -1;
    for (; at_ != end_ && std::isalpha(static_cast<unsigned char>(*at_)) && yarn < yarnCount_; ++at_)
      yarn = (yarn + 1) * 26 + (std::toupper(static_cast<unsigned char>(*at_)) - 'A');
    if (yarn < 0) throw InputError(kExpected);
    if (yarn >= yarnCount_) throw InputError(fmt::format("expected yarns from A to {}", yarnLetters(yarnCount_ - 1)));
    return yarn;
  }

  void skipBlanks() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == ',' || *at_ == '\n')) ++at_;
  }

  const char* at_;
  const char* const end_;
  int yarnCount_;
  size_t most_;
};

/// Runs that come again and again one after the other.
struct Group {
  size_t runs = 1, times = 1;
  size_t saved() const { return runs * (times - 1); }
};

/// The group at the beginning that leaves least to be written.
Group groupAt(std::span<const Stripe> rest) {
  constexpr size_t kLongestGroup = 64;
  Group best;
  for (size_t runs = 2; runs <= std::min(kLongestGroup, rest.size() / 2); ++runs) {
    size_t times = 1;
    while ((times + 1) * runs <= rest.size() && std::equal(rest.begin(), rest.begin() + static_cast<ptrdiff_t>(runs),
                                                           rest.begin() + static_cast<ptrdiff_t>(times * runs)))
      ++times;
    if (const Group group{runs, times}; group.saved() > best.saved()) best = group;
  }
  return best;
}

std::string textOf(std::span<const Stripe> runs) {
  std::string text;
  for (size_t i = 0; i < runs.size();) {
    if (!text.empty()) text += ' ';
    const Group group = groupAt(runs.subspan(i));
    if (group.times > 1)
      text += fmt::format("{}({})", group.times, textOf(runs.subspan(i, group.runs)));
    else if (runs[i].width > 1)
      text += std::to_string(runs[i].width) + yarnLetters(runs[i].yarn);
    else
      text += yarnLetters(runs[i].yarn);
    i += group.runs * group.times;
  }
  return text;
}

}  // namespace

std::string yarnOrderText(const std::vector<int>& sequence) {
  const std::vector<Stripe> runs = stripesOf(sequence);
  return textOf(runs);
}

std::vector<int> yarnOrderFromText(std::string_view text, int yarnCount, int most) {
  return OrderReader(text, yarnCount, static_cast<size_t>(most)).read();
}

}  // namespace loomlight
