#include "ui/draft/thread_order.h"

#include <fmt/core.h>

#include <cctype>
#include <charconv>

#include "core/base/error.h"

namespace loomlight {
namespace {

/// Runs and groups of runs, read from the left.
class OrderReader {
 public:
  OrderReader(std::string_view text, int yarnCount, size_t maxThreads)
      : at_(text.data()), end_(text.data() + text.size()), yarnCount_(yarnCount), maxThreads_(maxThreads) {}

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
    if (depth > kDeepest) throw InputError("expected at most 8 brackets within each other");
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
      if (count * part.size() > maxThreads_ - sequence.size())
        throw InputError(fmt::format("expected at most {} threads", maxThreads_));
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
      throw InputError(fmt::format("expected a number from 1 to {} before a yarn's letter", maxThreads_));
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
    while (at_ != end_ && (*at_ == ' ' || *at_ == ',')) ++at_;
  }

  const char* at_;
  const char* const end_;
  int yarnCount_;
  size_t maxThreads_;
};

}  // namespace

std::string yarnLetters(int yarn) {
  std::string letters;
  for (int rest = yarn; rest >= 0; rest = rest / 26 - 1)
    letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
  return letters;
}

std::string threadOrderText(const std::vector<int>& sequence) {
  std::string text;
  for (size_t i = 0; i < sequence.size();) {
    size_t run = i;
    while (run < sequence.size() && sequence[run] == sequence[i]) ++run;
    if (!text.empty()) text += ' ';
    if (run - i > 1) text += std::to_string(run - i);
    text += yarnLetters(sequence[i]);
    i = run;
  }
  return text;
}

std::vector<int> threadOrderFromText(std::string_view text, int yarnCount, int maxThreads) {
  return OrderReader(text, yarnCount, static_cast<size_t>(maxThreads)).read();
}

}  // namespace loomlight
