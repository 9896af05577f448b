#include "render/colour/illuminants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "render/colour/illuminant_tables.h"
#include "render/colour/spectrum.h"

// How it works. Everything is taken to every nm on the way in: formulas are evaluated there, tables are joined by
// straight lines, as CIE 15 says of daylight. Lamps are tabulated from 380 nm; below that they stay as they are there.

namespace loomlight {
namespace {

template <class Power>
Illuminant everyNm(std::string name, Power&& power) {
  Illuminant light{std::move(name)};
  for (size_t i = 0; i < kVisible; ++i)
    light.power[i] = power(static_cast<double>(kFirstVisible_nm + static_cast<int>(i)));
  return light;
}

/// On the straight line between two entries of a table; its ends go on.
double between(std::span<const double> table, double first_nm, double step_nm, double nm) {
  const double at = std::clamp((nm - first_nm) / step_nm, 0.0, static_cast<double>(table.size() - 1));
  const size_t before = std::min(static_cast<size_t>(at), table.size() - 2);
  return std::lerp(table[before], table[before + 1], at - static_cast<double>(before));
}

/// CIE 15:2018, 4.1.2: the chromaticity of daylight of a temperature, and the components that make it.
Illuminant daylight(std::string name, double kelvin) {
  const double t = 1e3 / kelvin;
  const double x = kelvin <= 7000 ? 0.244063 + t * (0.09911 + t * (2.9678 - t * 4.6070))
                                  : 0.237040 + t * (0.24748 + t * (1.9018 - t * 2.0064));
  const double y = -0.275 + x * (2.870 - 3.000 * x);
  const double below = 0.0241 + 0.2562 * x - 0.7341 * y;
  const auto threeDecimals = [](double value) { return std::round(1000 * value) / 1000; };
  const double m1 = threeDecimals((-1.3515 - 1.7703 * x + 5.9114 * y) / below);
  const double m2 = threeDecimals((0.0300 - 31.4424 * x + 30.0717 * y) / below);
  const auto part = [](const DaylightTable& table, double nm) {
    return between(table, kFirstVisible_nm, kDaylightStep_nm, nm);
  };
  return everyNm(std::move(name), [&](double nm) {
    return part(kDaylightS0, nm) + m1 * part(kDaylightS1, nm) + m2 * part(kDaylightS2, nm);
  });
}

/// Temperatures in the names of daylight were given before Planck's second constant was set anew.
double nominalDaylight_K(double named_K) {
  return named_K * 1.4388 / 1.4380;
}

/// ISO/CIE 11664-2: its own constant stays in it, so that the illuminant is the one of 1931.
Illuminant illuminantA() {
  const auto body = [](double nm) { return std::pow(nm, -5) / std::expm1(1.435e7 / (2848 * nm)); };
  return everyNm("A", [&](double nm) { return 100 * body(nm) / body(560); });
}

Illuminant blackBody(double kelvin) {
  return everyNm(fmt::format("{:g} K", kelvin),
                 [=](double nm) { return 100 * planck(nm, kelvin) / planck(560, kelvin); });
}

std::string capitals(std::string_view text) {
  std::string upper(text);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

/// Fluorescent lamps have two names more: FL2, and that of the maker whose lamp stands in every shop.
bool isCalled(const LampTable& lamp, const std::string& name) {
  const std::string usual = lamp.name;
  return name == usual || (usual.starts_with('F') && name == "FL" + usual.substr(1)) ||
         (usual == "F11" && name == "TL84");
}

/// The temperature in "2856 K" and "2856k".
std::optional<double> temperature_K(std::string_view name) {
  double kelvin = 0;
  const auto [rest, error] = std::from_chars(name.data(), name.data() + name.size(), kelvin);
  const std::string_view unit = name.substr(static_cast<size_t>(rest - name.data()));
  if (error != std::errc() || (unit != "K" && unit != " K")) return std::nullopt;
  return kelvin;
}

}  // namespace

std::vector<std::string> illuminantNames() {
  std::vector<std::string> names{"D50", "D55", "D65", "A", "E"};
  for (const LampTable& lamp : lampTables()) names.emplace_back(lamp.name);
  return names;
}

Illuminant illuminantNamed(const std::string& name) {
  const std::string upper = capitals(name);
  for (const int hundreds : {50, 55, 65})
    if (const std::string series = fmt::format("D{}", hundreds); upper == series)
      return daylight(series, nominalDaylight_K(100 * hundreds));
  if (upper == "A") return illuminantA();
  if (upper == "E") return everyNm("E", [](double) { return 100.0; });
  for (const LampTable& lamp : lampTables())
    if (isCalled(lamp, upper))
      return everyNm(lamp.name, [&](double nm) { return between(lamp.power, kLampFirst_nm, kLampStep_nm, nm); });
  if (const std::optional<double> kelvin = temperature_K(upper)) {
    if (!(*kelvin >= 1000 && *kelvin <= 25000))
      throw InputError(fmt::format("illuminant \"{}\": expected a black body of 1000 to 25000 K", name));
    return blackBody(*kelvin);
  }
  throw InputError(fmt::format("illuminant \"{}\": expected one of {}, or a black body as \"2856 K\"", name,
                               fmt::join(illuminantNames(), ", ")));
}

Spectrum bandPower(const Illuminant& illuminant) {
  Spectrum bands;
  for (size_t j = 0; j < kBands; ++j) {
    const int middle = bandWavelength_nm(j) - kFirstVisible_nm;
    double sum = 0;
    for (int away = 1 - kBandStep_nm; away < kBandStep_nm; ++away)
      sum += (kBandStep_nm - std::abs(away)) * illuminant.power[middle + away];
    bands[j] = static_cast<float>(sum / (kBandStep_nm * kBandStep_nm));
  }
  return bands;
}

}  // namespace loomlight
