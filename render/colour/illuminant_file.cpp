#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text_encoding.h"
#include "render/colour/illuminants.h"

// How it works. A text of two columns, wavelength in nm and power, is read line by line; # begins a comment, and one
// line of headings may come first. Powers between its wavelengths lie on a line, those beyond its ends are as at the
// end. The spectrum is taken at every nm that is visible and scaled so that its largest value is 100. Cost: linear
// in the file.

namespace loomlight {
namespace {

constexpr size_t kMostLampBytes = 4'000'000;

struct Line {
  double nm, power;
};

bool isBetween(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r';
}

/// The next word of a line; empty at its end.
std::string_view nextWord(std::string_view& line) {
  while (!line.empty() && isBetween(line.front())) line.remove_prefix(1);
  const auto end = std::find_if(line.begin(), line.end(), isBetween);
  const std::string_view word = line.substr(0, end - line.begin());
  line.remove_prefix(word.size());
  return word;
}

std::optional<double> numberIn(std::string_view word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string_view withoutComment(std::string_view text) {
  return text.substr(0, text.find('#'));
}

bool isBlank(std::string_view text) {
  return std::all_of(text.begin(), text.end(), isBetween);
}

std::optional<Line> lineOf(std::string_view text) {
  const std::optional<double> nm = numberIn(nextWord(text)), power = numberIn(nextWord(text));
  if (!nm || !power || !nextWord(text).empty()) return std::nullopt;
  return Line{*nm, *power};
}

/// The lines of numbers, checked.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  void line(std::string_view text) {
    ++number_;
    text = withoutComment(text);
    if (isBlank(text)) return;
    const std::optional<Line> line = lineOf(text);
    if (!line && lines_.empty() && !headings_) {
      headings_ = true;
      return;
    }
    if (!line) wrong("expected two numbers, a wavelength in nm and a power");
    if (!lines_.empty() && line->nm <= lines_.back().nm) wrong("expected wavelengths that ascend");
    if (line->power < 0) wrong("expected a power of 0 or more");
    lines_.push_back(*line);
  }

  std::vector<Line> take() {
    constexpr double kLastBand_nm = bandWavelength_nm(kBands - 1);
    if (lines_.empty() || lines_.front().nm > kFirstBand_nm || lines_.back().nm < kLastBand_nm)
      throw InputError(fmt::format(
          "{}: expected two columns, wavelength in nm and power, from {} nm or less to {} nm or "
          "more{}",
          file_, kFirstBand_nm, kLastBand_nm,
          lines_.empty() ? "" : fmt::format("; it goes from {} to {}", lines_.front().nm, lines_.back().nm)));
    return std::move(lines_);
  }

 private:
  [[noreturn]] void wrong(const char* expected) const {
    throw InputError(fmt::format("{}: line {}: {}", file_, number_, expected));
  }

  const std::string& file_;
  int number_ = 0;
  bool headings_ = false;
  std::vector<Line> lines_;
};

std::vector<Line> readLines(const std::string& file) {
  const std::string content = decodeText(readFile(file, kMostLampBytes), file).text;
  Reader reader(file);
  for (std::string_view rest = content; !rest.empty();) reader.line(takeLine(rest));
  return reader.take();
}

double powerAt(const std::vector<Line>& lines, double nm) {
  const auto after =
      std::lower_bound(lines.begin(), lines.end(), nm, [](const Line& line, double at) { return line.nm < at; });
  if (after == lines.begin()) return lines.front().power;
  if (after == lines.end()) return lines.back().power;
  const Line& before = *(after - 1);
  return std::lerp(before.power, after->power, (nm - before.nm) / (after->nm - before.nm));
}

Illuminant readIlluminant(const std::string& file) {
  const std::vector<Line> lines = readLines(file);
  Illuminant light{std::filesystem::path(file).stem().string()};
  for (size_t i = 0; i < kVisible; ++i) light.power[i] = powerAt(lines, kFirstVisible_nm + static_cast<double>(i));
  const double most = *std::max_element(light.power.begin(), light.power.end());
  const double scale = 100 / most;
  if (!std::isfinite(scale))  // of none, or of less than numbers can be scaled from
    throw InputError(fmt::format("{}: expected a light that has power between 360 and 780 nm", file));
  for (double& power : light.power) power *= scale;
  return light;
}

bool looksLikeAFile(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::path(name).has_extension() || std::filesystem::exists(name, ignored);
}

}  // namespace

bool isIlluminantFile(const std::string& file) {
  std::string content;
  try {
    content = decodeText(readFile(file, kMostLampBytes), file).text;
  } catch (const InputError&) {
    return false;  // who opens it will say why
  }
  int headings = 0;
  for (std::string_view rest = content; !rest.empty() && headings < 2;) {
    const std::string_view line = withoutComment(takeLine(rest));
    if (lineOf(line)) return true;
    if (!isBlank(line)) ++headings;
  }
  return false;
}

Illuminant illuminantCalled(const std::string& nameOrFile) {
  try {
    return illuminantNamed(nameOrFile);
  } catch (const InputError&) {
    if (!looksLikeAFile(nameOrFile)) throw;
  }
  return readIlluminant(nameOrFile);
}

}  // namespace loomlight
