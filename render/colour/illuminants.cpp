#include "render/colour/illuminants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

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

Illuminant ofBlackBody(std::string name, double kelvin) {
  return everyNm(std::move(name), [=](double nm) { return 100 * planck(nm, kelvin) / planck(560, kelvin); });
}

Illuminant tabulated(const std::string& name) {
  const std::span<const LampTable> lamps = lampTables();
  const auto lamp =
      std::find_if(lamps.begin(), lamps.end(), [&](const LampTable& table) { return name == table.name; });
  assert(lamp != lamps.end());
  return everyNm(name, [&](double nm) { return between(lamp->power, kLampFirst_nm, kLampStep_nm, nm); });
}

}  // namespace

Illuminant illuminantOf(const NamedLamp& lamp) {
  using enum StandardIlluminant;
  const std::string name = lampName(lamp);
  switch (lamp.illuminant) {
    case d65:
      return daylight(name, nominalDaylight_K(6500));
    case d55:
      return daylight(name, nominalDaylight_K(5500));
    case d50:
      return daylight(name, nominalDaylight_K(5000));
    case a:
      return illuminantA();
    case e:
      return everyNm(name, [](double) { return 100.0; });
    case blackBody:
      return ofBlackBody(name, lamp.temperature_K);
    default:
      return tabulated(name);
  }
}

Illuminant illuminantNamed(const std::string& name) {
  const std::optional<NamedLamp> lamp = lampFromName(name);
  if (!lamp)
    throw InputError(fmt::format("illuminant \"{}\": expected one of {}, or a black body as \"2856 K\"", name,
                                 fmt::join(lampNames(), ", ")));
  const bool isBlackBody = lamp->illuminant == StandardIlluminant::blackBody;
  if (isBlackBody && !(lamp->temperature_K >= 1000 && lamp->temperature_K <= 25000))
    throw InputError(fmt::format("illuminant \"{}\": expected a black body of 1000 to 25000 K", name));
  return illuminantOf(*lamp);
}

}  // namespace loomlight
