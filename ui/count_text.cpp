#include "ui/count_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

#include "core/fabric/yarn_count.h"

namespace loomlight {
namespace {

std::optional<CountSystem> systemFromName(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  if (lower == "tex") return CountSystem::tex;
  if (lower == "dtex") return CountSystem::dtex;
  if (lower == "den" || lower == "denier") return CountSystem::denier;
  if (lower == "nm") return CountSystem::metric;
  if (lower == "ne" || lower == "nec") return CountSystem::cotton;
  if (lower == "nek" || lower == "new") return CountSystem::worsted;
  if (lower == "nel") return CountSystem::linen;
  return std::nullopt;
}

bool isIndirect(CountSystem system) {
  return system != CountSystem::tex && system != CountSystem::dtex && system != CountSystem::denier;
}

void skipBlanks(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
}

std::optional<double> takeNumber(std::string_view& text) {
  skipBlanks(text);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value) || value <= 0) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  skipBlanks(text);
  return value;
}

}  // namespace

std::optional<double> texFromText(std::string_view text) {
  const std::optional<double> first = takeNumber(text);
  if (!first) return std::nullopt;
  std::optional<double> second;
  if (!text.empty() && text.front() == '/') {
    text.remove_prefix(1);
    second = takeNumber(text);
    if (!second) return std::nullopt;
  }
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  const std::optional<CountSystem> system = systemFromName(text);
  if (!system) return std::nullopt;
  if (!second) return texFromCount(*first, *system);
  if (!isIndirect(*system)) return std::nullopt;
  // "30/2 Ne" and "2/60 Nm": nobody plies more strands than the number of the count.
  const double singles = std::max(*first, *second), plies = std::min(*first, *second);
  return plies * texFromCount(singles, *system);
}

}  // namespace loomlight
