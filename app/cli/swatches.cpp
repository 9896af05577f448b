#include "app/cli/swatches.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace loomlight {
namespace {

/// The whole text, and it cut at each colon, the longest name of a file first.
std::vector<SwatchChoice> possibleChoices(const std::string& text) {
  std::vector<SwatchChoice> choices{{text, ""}};
  for (size_t at = text.rfind(':'); at != std::string::npos && at > 0; at = text.rfind(':', at - 1))
    choices.push_back({text.substr(0, at), text.substr(at + 1)});
  return choices;
}

std::string someNames(const std::vector<MeasuredSwatch>& swatches) {
  constexpr size_t kMost = 8;
  std::string names;
  for (size_t i = 0; i < std::min(swatches.size(), kMost); ++i)
    names += fmt::format("{}'{}'", i ? ", " : "", swatches[i].name);
  return swatches.size() > kMost ? fmt::format("{} and {} more", names, swatches.size() - kMost) : names;
}

/// Names come first: a swatch may be called "2".
MeasuredSwatch swatchNamed(std::vector<MeasuredSwatch> swatches, const SwatchChoice& choice) {
  const auto isNamed = [&](const MeasuredSwatch& swatch) { return swatch.name == choice.name; };
  const auto found = std::find_if(swatches.begin(), swatches.end(), isNamed);
  if (found != swatches.end()) {
    if (std::count_if(found, swatches.end(), isNamed) == 1) return std::move(*found);
    throw InputError(fmt::format("{}: expected the number of the swatch, from 1, as several are named '{}'",
                                 choice.file, choice.name));
  }
  size_t number = 0;
  const char* const end = choice.name.data() + choice.name.size();
  const auto [stopped, error] = std::from_chars(choice.name.data(), end, number);
  if (error == std::errc{} && stopped == end && number >= 1 && number <= swatches.size())
    return std::move(swatches[number - 1]);
  throw InputError(
      fmt::format("{}: expected one of its swatches, {}; got '{}'", choice.file, someNames(swatches), choice.name));
}

}  // namespace

SwatchChoice swatchChoice(const std::string& text) {
  const std::vector<SwatchChoice> choices = possibleChoices(text);
  const auto isThere = [](const SwatchChoice& choice) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(choice.file, ignored);
  };
  auto found = std::find_if(choices.begin(), choices.end(), isThere);
  if (found == choices.end())  // of a file that is missing, who opens it says so
    found = std::find_if(choices.begin(), choices.end(),
                         [](const SwatchChoice& choice) { return isSwatchFile(choice.file); });
  return found == choices.end() ? choices.front() : *found;
}

bool isSwatch(const std::string& text) {
  return isSwatchFile(swatchChoice(text).file);
}

MeasuredSwatch swatchFrom(const std::string& text) {
  const SwatchChoice choice = swatchChoice(text);
  SwatchFile found = readSwatches(choice.file);
  for (const std::string& remark : found.remarks) fmt::print(stderr, "{}: {}\n", choice.file, remark);
  if (!choice.name.empty()) return swatchNamed(std::move(found.swatches), choice);
  if (found.swatches.size() > 1)
    fmt::print(stderr, "{0}: the first of {1} swatches is taken, '{2}'; {0}:NAME takes the one of that name\n",
               choice.file, found.swatches.size(), found.swatches.front().name);
  return std::move(found.swatches.front());
}

Spectrum reflectanceFrom(const std::string& text) {
  return bandReflectance(swatchFrom(text));
}

}  // namespace loomlight
