#include "core/fabric/model/check.h"

#include <fmt/format.h>

#include "core/fabric/model/field_tables.h"

namespace loomlight {

std::string expectedNumber(double min, double max) {
  return fmt::format("a number from {} to {}", min, max);
}

std::string expectedWhole(double min, double max) {
  return fmt::format("a whole number from {} to {}", min, max);
}

void check(const FieldInfo& info, double value, const Place& place) {
  // Not `value < min || value > max`: NaN has to fail too.
  if (!(value >= info.min && value <= info.max))
    place.reject(expectedNumber(info.min, info.max), fmt::format("{}", value));
}

void check(const FieldInfo& info, int value, const Place& place) {
  if (value < info.min || value > info.max) place.reject(expectedWhole(info.min, info.max), fmt::format("{}", value));
}

void check(const FieldInfo& info, const std::optional<int>& value, const Place& place) {
  if (value) check(info, *value, place);
}

void check(const FieldInfo& info, const std::optional<double>& value, const Place& place) {
  if (value) check(info, *value, place);
}

void check(const FieldInfo& info, const Rgb& value, const Place& place) {
  for (int i = 0; i < 3; ++i) check(info, static_cast<double>(value[i]), place.at(static_cast<size_t>(i)));
}

void check(const FieldInfo& info, const Spectrum& bands, const Place& place) {
  for (size_t j = 0; j < kBands; ++j) check(info, static_cast<double>(bands[j]), place.at(j));
}

void check(const FieldInfo& info, const Absorption& value, const Place& place) {
  const bool alone = !value.isSpectral();  // as it stands in a file
  check(info, value.primaries, alone ? place : place.at("primaries"));
  if (value.bands) check(info, *value.bands, place.at("bands"));
  const Place dyes = place.at("dyes");
  if (value.dyes.size() > Absorption::kMostDyes)
    dyes.reject(fmt::format("at most {} dyes", Absorption::kMostDyes), fmt::format("{}", value.dyes.size()));
  for (size_t i = 0; i < value.dyes.size(); ++i) {
    const Place here = dyes.at(i);
    forEachField<Dyestuff>(
        [&](const auto& field) { check(field.info, value.dyes[i].*field.member, here.at(field.info.key)); });
  }
}

void check(const FieldInfo& info, const glm::dvec3& value, const Place& place) {
  for (int i = 0; i < 3; ++i) check(info, value[i], place.at(static_cast<size_t>(i)));
}

void check(const FieldInfo&, const std::string& value, const Place& place) {
  if (value.size() > kMaxText)
    place.reject(fmt::format("a text of at most {} bytes", kMaxText), fmt::format("{}", value.size()));
}

}  // namespace loomlight
