#include "core/fabric/model/thread_spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <system_error>

#include "core/base/period.h"

namespace loomlight {

int spacingRepeat(const std::vector<double>& spacing) {
  return spacing.empty() ? 1 : static_cast<int>(shortestRepeat(spacing).size());
}

std::vector<double> displacements(const std::vector<double>& given) {
  if (spacingRepeat(given) == 1) return {};
  const std::vector<double> spacing = shortestRepeat(given);
  const double pitch = std::accumulate(spacing.begin(), spacing.end(), 0.0) / static_cast<double>(spacing.size());
  std::vector<double> displaced;
  double place = 0;
  for (size_t thread = 0; thread < spacing.size(); ++thread) {
    displaced.push_back(place / pitch - static_cast<double>(thread));
    place += spacing[thread];
  }
  const auto [least, most] = std::minmax_element(displaced.begin(), displaced.end());
  const double middle = 0.5 * (*least + *most);
  for (double& thread : displaced) thread -= middle;
  return displaced;
}

std::vector<double> mirroredSpacing(const std::vector<double>& spacing) {
  if (spacing.empty()) return {};
  // The distance after the last thread is that before the first, which is then the last.
  std::vector<double> mirrored(spacing.rbegin() + 1, spacing.rend());
  mirrored.push_back(spacing.back());
  return mirrored;
}

std::string spacingText(const std::vector<double>& spacing) {
  std::string text;
  for (const double distance : spacing) text += fmt::format("{}{}", text.empty() ? "" : " ", distance);
  return text;
}

std::optional<std::vector<double>> spacingFromText(const std::string& text) {
  std::vector<double> spacing;
  const char *at = text.data(), *const end = at + text.size();
  while (true) {
    at = std::find_if(at, end, [](char c) { return c != ' '; });
    if (at == end) return spacing;
    double distance = 0;
    const auto [next, error] = std::from_chars(at, end, distance);
    if (error != std::errc() || (next != end && *next != ' ')) return std::nullopt;
    if (!(distance >= kSpacingRange.min && distance <= kSpacingRange.max)) return std::nullopt;
    spacing.push_back(distance);
    if (spacing.size() > static_cast<size_t>(kMostSpacing)) return std::nullopt;
    at = next;
  }
}

}  // namespace loomlight
