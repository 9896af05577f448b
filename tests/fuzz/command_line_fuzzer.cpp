#include "app/cli/commands/command_line.h"
#include "app/cli/usage_error.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"

namespace loomlight::fuzz {

/// What is asked for is not done: that is for the files which are asked for.
void fuzzCommandLine(std::string_view bytes) {
  std::vector<std::string> words;
  for (size_t at = 0; at < bytes.size();) {
    const size_t end = std::min(bytes.find('\n', at), bytes.size());
    words.emplace_back(bytes.substr(at, end - at).substr(0, bytes.substr(at, end - at).find('\0')));
    at = end + 1;
  }
  try {
    (void)parseCommandLine(words);
  } catch (const UsageError& error) {
    expect(error.what()[0] != '\0', "a command line is refused without a word");
  }
}

}  // namespace loomlight::fuzz
