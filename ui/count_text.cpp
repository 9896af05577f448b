#include "ui/count_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "core/fabric/field_tables.h"
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

/// How a yarn is folded, and cabled then.
struct Folds {
  std::vector<double> numbers;
  std::optional<int> at(size_t i, const FieldInfo& info) const {
    const double number = numbers[i];
    if (number != std::floor(number) || number > info.max) return std::nullopt;
    return static_cast<int>(number);
  }
};

/// The folds behind a count, where there are any: "x 2", "/2", "/2/3". False when they are none.
bool readFolds(Tokens& tokens, const char* sign, Folds& folds) {
  while (tokens.take(sign)) {
    const std::optional<double> number = tokens.number();
    if (!number || folds.numbers.size() == 2) return false;
    folds.numbers.push_back(*number);
  }
  return true;
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
  std::optional<double> count = tokens.number();
  if (!count) return std::nullopt;
  Folds times, over;
  if (!readFolds(tokens, "x", times) || !readFolds(tokens, "/", over)) return std::nullopt;
  if (const std::string_view after = tokens.word(); !after.empty()) {
    if (system) return std::nullopt;
    system = systemFromName(after);
    if (!system || !readFolds(tokens, "x", times) || !readFolds(tokens, "/", over)) return std::nullopt;
  }
  const bool isOver = !over.numbers.empty();
  Folds& folds = isOver ? over : times;
  if (!tokens.end() || (isOver && !times.numbers.empty())) return std::nullopt;

  const CountSystem in = system.value_or(usual);
  if (folds.numbers.empty()) return CountEntry{texFromCount(*count, in), std::nullopt, std::nullopt};
  const bool singles = !(isOver && resultant);  // the count is that of the singles
  if (isOver && singles && !isIndirect(in)) return std::nullopt;
  // "30/2 Ne" and "2/60 Nm": nobody plies more strands than the number of the count.
  if (isOver && singles && folds.numbers.size() == 1 && folds.numbers[0] > *count) std::swap(*count, folds.numbers[0]);
  const std::optional<int> plies = folds.at(0, fieldInfo(&Yarn::plies));
  const std::optional<int> cords = folds.numbers.size() == 2 ? folds.at(1, fieldInfo(&Yarn::cords)) : 1;
  if (!plies || !cords) return std::nullopt;
  return CountEntry{(singles ? *plies * *cords : 1) * texFromCount(*count, in), plies, cords};
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
