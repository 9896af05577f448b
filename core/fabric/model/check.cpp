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

void check(const FieldInfo& info, double value, const FieldPath& path) {
  // Not `value < min || value > max`: NaN has to fail too.
  if (!(value >= info.min && value <= info.max))
    path.reject(expectedNumber(info.min, info.max), fmt::format("{}", value));
}

void check(const FieldInfo& info, int value, const FieldPath& path) {
  if (value < info.min || value > info.max) path.reject(expectedWhole(info.min, info.max), fmt::format("{}", value));
}

void check(const FieldInfo& info, const std::optional<int>& value, const FieldPath& path) {
  if (value) check(info, *value, path);
}

void check(const FieldInfo& info, const std::optional<double>& value, const FieldPath& path) {
  if (value) check(info, *value, path);
}

void check(const FieldInfo& info, const Rgb& value, const FieldPath& path) {
  for (int i = 0; i < 3; ++i) check(info, static_cast<double>(value[i]), path.at(static_cast<size_t>(i)));
}

void check(const FieldInfo& info, const Spectrum& bands, const FieldPath& path) {
  for (size_t j = 0; j < kBands; ++j) check(info, static_cast<double>(bands[j]), path.at(j));
}

void check(const FieldInfo& info, const Absorption& value, const FieldPath& path) {
  const bool alone = !value.isSpectral();  // as it stands in a file
  check(info, value.primaries, alone ? path : path.at("primaries"));
  if (value.bands) check(info, *value.bands, path.at("bands"));
  const FieldPath dyes = path.at("dyes");
  if (value.dyes.size() > Absorption::kMostDyes)
    dyes.reject(fmt::format("at most {} dyes", Absorption::kMostDyes), fmt::format("{}", value.dyes.size()));
  for (size_t i = 0; i < value.dyes.size(); ++i) {
    const FieldPath here = dyes.at(i);
    forEachField<Dyestuff>(
        [&](const auto& field) { check(field.info, value.dyes[i].*field.member, here.at(field.info.key)); });
  }
}

void check(const FieldInfo& info, const glm::dvec3& value, const FieldPath& path) {
  for (int i = 0; i < 3; ++i) check(info, value[i], path.at(static_cast<size_t>(i)));
}

void check(const FieldInfo&, const std::string& value, const FieldPath& path) {
  if (value.size() > kMaxText)
    path.reject(fmt::format("a text of at most {} bytes", kMaxText), fmt::format("{}", value.size()));
}

}  // namespace loomlight
