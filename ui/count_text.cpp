#include "ui/count_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

#include "core/fabric/presets.h"

namespace loomlight {
namespace {

std::optional<CountSystem> systemFromName(std::string_view name) {
  if (name == "tex") return CountSystem::tex;
  if (name == "dtex") return CountSystem::dtex;
  if (name == "den" || name == "denier") return CountSystem::denier;
  if (name == "nm") return CountSystem::metric;
  if (name == "ne" || name == "nec") return CountSystem::cotton;
  if (name == "nek" || name == "new") return CountSystem::worsted;
  if (name == "nel") return CountSystem::linen;
  return std::nullopt;
}

/// Numbers, words and signs of a text, one after the other; blanks lie between them.
class Tokens {
 public:
  explicit Tokens(std::string_view text) {
    for (const char c : text) text_ += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    rest_ = text_;
    skipBlanks();
  }
  bool end() const { return rest_.empty(); }
  /// A positive number.
  std::optional<double> number() {
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || !std::isfinite(value) || value <= 0) return std::nullopt;
    advance(static_cast<size_t>(end - rest_.data()));
    return value;
  }
  std::string_view word() {
    size_t length = 0;
    while (length < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[length]))) ++length;
    const std::string_view found = rest_.substr(0, length);
    advance(length);
    return found;
  }
  bool take(std::string_view sign) {
    if (rest_.substr(0, sign.size()) != sign) return false;
    advance(sign.size());
    return true;
  }

 private:
  void advance(size_t length) {
    rest_.remove_prefix(length);
    skipBlanks();
  }
  void skipBlanks() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }
  std::string text_;
  std::string_view rest_;
};

std::optional<int> asPlies(double number) {
  constexpr int kMostPlies = 8;
  if (number != std::floor(number) || number > kMostPlies) return std::nullopt;
  return static_cast<int>(number);
}

/// The number of plies behind a count, where there is one: "x 2" or "/2". False when it is none, or a second one.
bool readPlies(Tokens& tokens, const char* sign, std::optional<double>& plies) {
  if (!tokens.take(sign)) return true;
  if (plies) return false;
  plies = tokens.number();
  return plies.has_value();
}

}  // namespace

std::optional<CountEntry> countFromText(std::string_view text, CountSystem usual) {
  Tokens tokens(text);
  const bool resultant = tokens.take("r");
  std::optional<CountSystem> system;
  if (const std::string_view before = tokens.word(); !before.empty()) {
    system = systemFromName(before);
    if (!system) return std::nullopt;
  }
  const std::optional<double> first = tokens.number();
  if (!first) return std::nullopt;
  std::optional<double> times, over;
  if (!readPlies(tokens, "x", times) || !readPlies(tokens, "/", over)) return std::nullopt;
  if (const std::string_view after = tokens.word(); !after.empty()) {
    if (system) return std::nullopt;
    system = systemFromName(after);
    if (!system || !readPlies(tokens, "x", times) || !readPlies(tokens, "/", over)) return std::nullopt;
  }
  if (!tokens.end() || (times && over)) return std::nullopt;

  const CountSystem in = system.value_or(usual);
  if (over && !resultant) {
    if (!isIndirect(in)) return std::nullopt;
    // "30/2 Ne" and "2/60 Nm": nobody plies more strands than the number of the count.
    const std::optional<int> plies = asPlies(std::min(*first, *over));
    if (!plies) return std::nullopt;
    return CountEntry{*plies * texFromCount(std::max(*first, *over), in), plies};
  }
  if (times || over) {
    const std::optional<int> plies = asPlies(times ? *times : *over);
    if (!plies) return std::nullopt;
    return CountEntry{(times ? *plies : 1) * texFromCount(*first, in), plies};
  }
  return CountEntry{texFromCount(*first, in), std::nullopt};
}

std::optional<double> twistFromText(std::string_view text, double tex) {
  constexpr double kInchesPerMetre = 1 / 0.0254;
  Tokens tokens(text);
  const std::optional<double> value = tokens.number();
  if (!value) return std::nullopt;
  if (tokens.take("t/m") || tokens.take("turns/m")) return tokens.end() ? value : std::nullopt;
  if (tokens.take("tpi")) return tokens.end() ? std::optional(*value * kInchesPerMetre) : std::nullopt;
  if (tokens.take("tm")) return tokens.end() ? std::optional(twist_per_m(*value, tex)) : std::nullopt;
  return std::nullopt;
}

}  // namespace loomlight
