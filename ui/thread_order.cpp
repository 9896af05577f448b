#include "ui/thread_order.h"

#include <fmt/core.h>

#include <cctype>
#include <charconv>

#include "core/base/error.h"

namespace loomlight {

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
  std::vector<int> sequence;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  auto skipBlanks = [&] {
    while (at != end && (*at == ' ' || *at == ',')) ++at;
  };
  for (skipBlanks(); at != end; skipBlanks()) {
    int count = 1;
    if (std::isdigit(static_cast<unsigned char>(*at))) {
      const auto [next, error] = std::from_chars(at, end, count);
      if (error != std::errc() || count < 1)
        throw InputError(fmt::format("expected a number from 1 to {} before a yarn's letter", maxThreads));
      at = next;
    }
    int yarn = -1;
    for (; at != end && std::isalpha(static_cast<unsigned char>(*at)) && yarn < yarnCount; ++at)
      yarn = (yarn + 1) * 26 + (std::toupper(static_cast<unsigned char>(*at)) - 'A');
    if (yarn < 0) throw InputError("expected threads such as 4A 2B: how many, then the yarn's letter");
    if (yarn >= yarnCount) throw InputError(fmt::format("expected yarns from A to {}", yarnLetters(yarnCount - 1)));
    if (count > maxThreads - static_cast<int>(sequence.size()))
      throw InputError(fmt::format("expected at most {} threads", maxThreads));
    sequence.insert(sequence.end(), static_cast<size_t>(count), yarn);
  }
  if (sequence.empty()) throw InputError("expected threads such as 4A 2B: how many, then the yarn's letter");
  return sequence;
}

}  // namespace loomlight
