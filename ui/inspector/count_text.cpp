#include "ui/inspector/count_text.h"

#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/yarn/presets.h"
#include "ui/widgets/number_text.h"

namespace loomlight {
namespace {

std::optional<CountSystem> systemFromName(std::string_view name) {
  if (name == "tex") return CountSystem::tex;
  if (name == "dtex") return CountSystem::dtex;
  if (name == "den" || name == "denier" || name == "d") return CountSystem::denier;
  if (name == "nm") return CountSystem::metric;
  if (name == "ne" || name == "nec" || name == "cc" || name == "s") return CountSystem::cotton;
  if (name == "nek" || name == "new") return CountSystem::worsted;
  if (name == "nel" || name == "lea") return CountSystem::linen;
  return std::nullopt;
}

/// Numbers, words and signs of a text, one after the other; blanks lie between them.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(lowerCase(text)) {
    rest_ = text_;
    skipBlanks();
  }
  bool end() const { return rest_.empty(); }
  /// A positive number.
  std::optional<double> number() {
    const std::optional<LeadingNumber> leading = leadingNumber(rest_);
    if (!leading || leading->value <= 0) return std::nullopt;
    advance(leading->length);
    return leading->value;
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

/// The parts of a written count, before anybody knows what they mean together.
struct CountWords {
  bool resultant = false;  ///< "R": what all strands make together
  std::optional<CountSystem> system;
  double count = 0;
  std::vector<double> times, over;  ///< behind "x" and behind "/"
  std::optional<double> filaments;
};

/// One part behind the count: a fold, filaments or the unit. False when it is none of them.
bool readPart(Tokens& tokens, CountWords& words) {
  const bool times = tokens.take("x") || tokens.take("\xC3\x97"), over = !times && tokens.take("/");
  const bool filaments = !times && !over && tokens.take("f");
  if (!times && !over && !filaments) {
    if (words.system) return false;
    words.system = systemFromName(tokens.word());
    return words.system.has_value();
  }
  const std::optional<double> number = tokens.number();
  if (!number) return false;
  if (filaments || (over && tokens.take("f"))) {
    if (words.filaments) return false;
    words.filaments = number;
  } else {
    (times ? words.times : words.over).push_back(*number);
  }
  return true;
}

std::optional<CountWords> readWords(std::string_view text) {
  Tokens tokens(text);
  CountWords words;
  words.resultant = tokens.take("r");
  if (const std::string_view before = tokens.word(); !before.empty()) {
    words.system = systemFromName(before);
    if (!words.system) return std::nullopt;
  }
  const std::optional<double> count = tokens.number();
  if (!count) return std::nullopt;
  words.count = *count;
  while (!tokens.end())
    if (!readPart(tokens, words)) return std::nullopt;
  return words;
}

/// Raw silk is reeled to a range, "20/22 den": its middle is meant.
bool isRange(const CountWords& words) {
  constexpr double kWidest = 1.25;  // beyond, the second number is one of filaments
  return !words.resultant && words.over.size() == 1 && words.over[0] > words.count &&
         words.over[0] < kWidest * words.count;
}

std::optional<int> wholeUpTo(double number, double most) {
  if (number != std::floor(number) || number > most) return std::nullopt;
  return static_cast<int>(number);
}

}  // namespace

std::optional<CountEntry> countFromText(std::string_view text, CountSystem usual) {
  std::optional<CountWords> words = readWords(text);
  if (!words) return std::nullopt;
  const CountSystem in = words->system.value_or(usual);
  double count = words->count;
  if (!isIndirect(in) && isRange(*words)) {
    count = 0.5 * (count + words->over[0]);
    words->over.clear();
  }
  if ((!words->over.empty() && !words->times.empty()) || (words->filaments && words->resultant)) return std::nullopt;

  CountEntry entry;
  if (words->filaments) {
    entry.filaments = wholeUpTo(*words->filaments, fieldInfo(&Yarn::fibresPerPly).max);
    if (!entry.filaments) return std::nullopt;
  }
  const bool over = !words->over.empty();
  std::vector<double>& folds = over ? words->over : words->times;
  entry.ofSingles = !words->resultant && (isIndirect(in) || !folds.empty());
  if (over && entry.ofSingles && !isIndirect(in)) return std::nullopt;
  // "30/2 Ne" and "2/60 Nm": nobody plies more strands than the number of the count.
  if (over && entry.ofSingles && folds.size() == 1 && folds[0] > count) std::swap(count, folds[0]);
  entry.tex = texFromCount(count, in);
  if (folds.empty() && entry.filaments) folds = {1};
  if (folds.empty()) return entry;
  if (folds.size() > 2) return std::nullopt;
  entry.plies = wholeUpTo(folds[0], fieldInfo(&Yarn::plies).max);
  entry.cords = folds.size() == 2 ? wholeUpTo(folds[1], fieldInfo(&Yarn::cords).max) : 1;
  return entry.plies && entry.cords ? std::optional(entry) : std::nullopt;
}

std::optional<double> finenessFromText(std::string_view text, double density_g_cm3) {
  Tokens tokens(text);
  const std::optional<double> value = tokens.number();
  if (!value) return std::nullopt;
  if (tokens.take("\xC2\xB5m") || tokens.take("mic") || tokens.take("um")) {
    Fibre fibre;
    fibre.radius_um = 0.5 * *value;
    fibre.density_g_cm3 = density_g_cm3;
    return tokens.end() ? std::optional(fibreFineness_dtex(fibre)) : std::nullopt;
  }
  const std::optional<CountSystem> system = systemFromName(tokens.word());
  if (!system || isIndirect(*system) || !tokens.end()) return std::nullopt;
  return countFromTex(texFromCount(*value, *system), CountSystem::dtex);
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
