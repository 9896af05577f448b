#include "core/fabric/json/object_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/json/band_samples.h"
#include "core/fabric/model/field_tables.h"

namespace loomlight::from_json {

std::string shown(const json& value) {
  if (value.is_array()) return "a list";
  if (value.is_object()) return "an object";
  if (value.is_string()) return quotedText(value.get_ref<const std::string&>());
  return value.dump();
}

int readWhole(const json& value, double min, double max, const FieldPath& path) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= min && number <= max) || number != std::floor(number))
    path.reject(expectedWhole(min, max), shown(value));
  return static_cast<int>(number);
}

const json::array_t& readList(const json& value, const char* expected, const FieldPath& path) {
  if (!value.is_array()) path.reject(expected, shown(value));
  return value.get_ref<const json::array_t&>();
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, double& out) {
  if (!value.is_number()) path.reject(expectedNumber(info.min, info.max), shown(value));
  out = value.get<double>();
  check(info, out, path);
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, int& out) {
  out = readWhole(value, info.min, info.max, path);
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, std::optional<int>& out) {
  out = readWhole(value, info.min, info.max, path);
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, std::optional<double>& out) {
  read(value, info, path, out.emplace());
}

void read(const json& value, const FieldInfo&, const FieldPath& path, uint64_t& out) {
  if (!value.is_number_unsigned()) path.reject("a whole number from 0 to 18446744073709551615", shown(value));
  out = value.get<uint64_t>();
}

void read(const json& value, const FieldInfo&, const FieldPath& path, bool& out) {
  if (!value.is_boolean()) path.reject("true or false", shown(value));
  out = value.get<bool>();
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, std::string& out) {
  if (!value.is_string()) path.reject("a text", shown(value));
  out = value.get<std::string>();
  check(info, out, path);
}

namespace {

template <class Vector>
void readTriple(const json& value, const FieldInfo& info, const FieldPath& path, Vector& out) {
  const json::array_t& list = readList(value, "a list of 3 numbers", path);
  if (list.size() != 3) path.reject("a list of 3 numbers", fmt::format("{}", list.size()));
  for (int i = 0; i < 3; ++i) {
    double number = 0;
    read(list[static_cast<size_t>(i)], info, path.at(static_cast<size_t>(i)), number);
    out[i] = static_cast<typename Vector::value_type>(number);
  }
}

}  // namespace

void read(const json& value, const FieldInfo& info, const FieldPath& path, Rgb& out) {
  readTriple(value, info, path, out);
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, glm::dvec3& out) {
  readTriple(value, info, path, out);
}

namespace {

/// Of as many samples as there are, evenly apart, the values at the bands: between two along a line, beyond the ends as
/// at the end.
Spectrum atBands(const std::vector<double>& values, double from_nm, double step_nm) {
  Spectrum bands;
  const double last = static_cast<double>(values.size() - 1);
  for (size_t j = 0; j < kBands; ++j) {
    const double position = std::clamp((bandWavelength_nm(j) - from_nm) / step_nm, 0.0, last);
    const auto below = static_cast<size_t>(position), above = std::min(below + 1, values.size() - 1);
    bands[j] = static_cast<float>(std::lerp(values[below], values[above], position - static_cast<double>(below)));
  }
  return bands;
}

std::vector<Dyestuff> readDyes(json value, const FieldPath& path) {
  readList(value, "a list of dyes", path);
  std::vector<Dyestuff> dyes;
  for (size_t i = 0; i < value.size() && i <= Absorption::kMostDyes; ++i) {
    const FieldPath here = path.at(i);
    ObjectReader reader(std::move(value[i]), here);
    reader.takeFields(dyes.emplace_back());
    reader.expectNoMore("a dye's name, amount_percent and absorption_per_mm");
  }
  return dyes;
}

}  // namespace

void read(const json& value, const FieldInfo& info, const FieldPath& path, Spectrum& out) {
  const std::string expected =
      fmt::format("a list of {} numbers, from {} to {} nm", kBands, kFirstBand_nm, bandWavelength_nm(kBands - 1));
  double from_nm = kFirstBand_nm, step_nm = kBandStep_nm;
  std::vector<double> values;
  const auto readValues = [&](const json& list, const FieldPath& there) {
    for (size_t i = 0; i < list.size(); ++i) read(list[i], info, there.at(i), values.emplace_back());
  };
  if (!value.is_object()) {
    if (readList(value, expected.c_str(), path).size() != kBands)
      path.reject(expected, fmt::format("{}", value.size()));
    readValues(value, path);
  } else {
    const FieldPath there = path.at("values");
    ObjectReader reader(value, path);
    reader.take("from_nm", band_samples::kFrom_nm, from_nm);
    reader.take("step_nm", band_samples::kStep_nm, step_nm);
    const json list = reader.take("values").value_or(json());
    const size_t count = readList(list, "a list of numbers", there).size();
    if (count < band_samples::kFewest || count > band_samples::kMost)
      there.reject(fmt::format("from {} to {} numbers", band_samples::kFewest, band_samples::kMost),
                   fmt::format("{}", count));
    readValues(list, there);
    reader.expectNoMore("from_nm, step_nm and values");
    constexpr double kFewestFrom_nm = 400, kFewestTo_nm = 700;
    const double to_nm = from_nm + step_nm * static_cast<double>(count - 1);
    if (from_nm > kFewestFrom_nm || to_nm < kFewestTo_nm)
      there.reject("values from 400 to 700 nm at least", fmt::format("from {} to {}", from_nm, to_nm));
  }
  out = atBands(values, from_nm, step_nm);
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, Absorption& out) {
  out = {};
  if (!value.is_object()) return read(value, info, path, out.primaries);
  ObjectReader reader(value, path);
  reader.take("primaries", info, out.primaries);
  if (const std::optional<json> bands = reader.take("bands")) read(*bands, info, path.at("bands"), out.bands.emplace());
  if (std::optional<json> dyes = reader.take("dyes")) out.dyes = readDyes(std::move(*dyes), path.at("dyes"));
  reader.expectNoMore("primaries, bands and dyes");
}

std::vector<double> takeNumbers(ObjectReader& reader, const char* key, const FieldInfo& info, const FieldPath& path) {
  const std::optional<json> list = reader.take(key);
  if (!list) return {};
  const FieldPath here = path.at(key);
  std::vector<double> numbers(readList(*list, "a list of numbers", here).size());
  for (size_t i = 0; i < numbers.size(); ++i) read((*list)[i], info, here.at(i), numbers[i]);
  return numbers;
}

}  // namespace loomlight::from_json
