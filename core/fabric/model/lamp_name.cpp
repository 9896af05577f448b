#include "core/fabric/model/lamp_name.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/fabric/model/choice_names.h"

// How it works. The names of choices in files are those of the CIE in small letters, with "_" for "-": a name is
// brought to these letters and looked up there, and the other way round.

namespace loomlight {
namespace {

bool hasName(StandardIlluminant lamp) {
  return lamp != StandardIlluminant::blackBody && lamp != StandardIlluminant::file;
}

char asInFiles(char c) {
  if (c == '-' || c == ' ') return '_';
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

char asTheCieWrites(char c) {
  if (c == '_') return '-';
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Of "2856_k" and "2856k".
std::optional<double> temperature_K(std::string_view name) {
  double kelvin = 0;
  const auto [rest, error] = std::from_chars(name.data(), name.data() + name.size(), kelvin);
  const std::string_view unit = name.substr(static_cast<size_t>(rest - name.data()));
  const bool isOne = error == std::errc() && (unit == "k" || unit == "_k") && std::isfinite(kelvin) && kelvin > 0;
  return isOne ? std::optional(kelvin) : std::nullopt;
}

}  // namespace

std::optional<NamedLamp> lampFromName(std::string_view name) {
  std::string known(name);
  for (char& c : known) c = asInFiles(c);
  if (const auto kelvin = temperature_K(known)) return NamedLamp{StandardIlluminant::blackBody, *kelvin};
  if (known == "tl84") known = "f11";
  if (known.starts_with("fl")) known.erase(1, 1);
  const auto lamp = choiceFromName<StandardIlluminant>(known);
  return lamp && hasName(*lamp) ? std::optional(NamedLamp{*lamp}) : std::nullopt;
}

std::string lampName(const NamedLamp& lamp) {
  if (lamp.illuminant == StandardIlluminant::blackBody) return fmt::format("{:g} K", lamp.temperature_K);
  std::string name = choiceName(lamp.illuminant);
  for (char& c : name) c = asTheCieWrites(c);
  return name;
}

std::vector<std::string> lampNames() {
  std::vector<std::string> names;
  for (size_t i = 0; i < ChoiceNames<StandardIlluminant>::names.size(); ++i) {
    const auto lamp = static_cast<StandardIlluminant>(i);
    if (hasName(lamp)) names.push_back(lampName({lamp}));
  }
  return names;
}

}  // namespace loomlight
