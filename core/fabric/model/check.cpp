#include "core/fabric/model/check.h"

#include <fmt/format.h>

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

void check(const FieldInfo& info, const glm::dvec3& value, const Place& place) {
  for (int i = 0; i < 3; ++i) check(info, value[i], place.at(static_cast<size_t>(i)));
}

void check(const FieldInfo&, const std::string& value, const Place& place) {
  if (value.size() > kMaxText)
    place.reject(fmt::format("a text of at most {} bytes", kMaxText), fmt::format("{}", value.size()));
}

}  // namespace loomlight
