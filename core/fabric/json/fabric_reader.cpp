#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/fabric/json/band_samples.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/check.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/wif/wif_reader.h"

// How it works. Each object is read through its table of fields (field_tables.h): known keys are taken out one by
// one, checked against the range in the table, and what remains is kept as text for the way back. Which field an
// error is in, its FieldPath knows. What is not in the tables, because it is a list or may be written in several
// ways (weave, draft, sequences, colours, bands), has a function of its own. The fabric is validated as a whole at
// the end. Cost: linear in the values.

namespace loomlight {
namespace {

using nlohmann::json;

/// A value, for the "got" of a message.
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

void read(const json& value, const FieldInfo& info, const FieldPath& path, Rgb& out) {
  readTriple(value, info, path, out);
}

void read(const json& value, const FieldInfo& info, const FieldPath& path, glm::dvec3& out) {
  readTriple(value, info, path, out);
}

template <class Enum>
void read(const json& value, const FieldInfo&, const FieldPath& path, Enum& out)
  requires std::is_enum_v<Enum>
{
  const std::optional<Enum> choice =
      value.is_string() ? choiceFromName<Enum>(value.get_ref<const std::string&>()) : std::nullopt;
  if (!choice) path.reject(choiceList<Enum>(), shown(value));
  out = *choice;
}

// Read from objects, and so below.
void read(const json& value, const FieldInfo& info, const FieldPath& path, Spectrum& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, Absorption& out);

/// An object whose known keys are taken out one by one; what remains is what this version does not know.
class ObjectReader {
 public:
  ObjectReader(json value, const FieldPath& path) : object_(std::move(value)), path_(path) {
    if (!object_.is_object()) path_.reject("an object", shown(object_));
  }

  std::optional<json> take(const char* key) {
    const auto found = object_.find(key);
    if (found == object_.end()) return std::nullopt;
    std::optional<json> value(std::move(*found));
    object_.erase(found);
    return value;
  }

  bool has(const char* key) const { return object_.contains(key); }
  bool has(const char* key, const char* keyInIt) const {
    const auto found = object_.find(key);
    return found != object_.end() && found->is_object() && found->contains(keyInIt);
  }

  /// The value of a key, where it is there.
  template <class Value>
  void take(const char* key, const FieldInfo& info, Value& out) {
    if (const std::optional<json> value = take(key)) read(*value, info, path_.at(key), out);
  }

  template <class Object>
  void takeFields(Object& object) {
    forEachField<Object>([&](const auto& field) {
      if (const std::optional<json> value = take(field.info.key))
        read(*value, field.info, path_.at(field.info.key), object.*field.member);
    });
  }

  /// Of a value that has no place for what this version does not know.
  void expectNoMore(const char* expected) const {
    if (!object_.empty()) path_.reject(expected, quotedText(object_.begin().key()));
  }

  UnknownKeys rest() const { return object_.empty() ? nullptr : std::make_shared<const std::string>(object_.dump()); }

 private:
  json object_;
  const FieldPath& path_;
};

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

/// Either a list with a number for each band, or an object that says where its values lie.
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

/// Three numbers, or what is known beyond them.
void read(const json& value, const FieldInfo& info, const FieldPath& path, Absorption& out) {
  out = {};
  if (!value.is_object()) return read(value, info, path, out.primaries);
  ObjectReader reader(value, path);
  reader.take("primaries", info, out.primaries);
  if (const std::optional<json> bands = reader.take("bands")) read(*bands, info, path.at("bands"), out.bands.emplace());
  if (std::optional<json> dyes = reader.take("dyes")) out.dyes = readDyes(std::move(*dyes), path.at("dyes"));
  reader.expectNoMore("primaries, bands and dyes");
}

template <class Object>
Object readObject(json value, const FieldPath& path) {
  ObjectReader reader(std::move(value), path);
  Object object;
  reader.takeFields(object);
  object.unknown = reader.rest();
  return object;
}

template <class Object>
std::vector<Object> readObjects(json value, const FieldPath& path) {
  readList(value, "a list of objects", path);
  std::vector<Object> objects;
  for (size_t i = 0; i < value.size() && i <= kMaxKinds; ++i)
    objects.push_back(readObject<Object>(std::move(value[i]), path.at(i)));
  return objects;
}

std::vector<Colourway> readColourways(json value, const FieldPath& path) {
  readList(value, "a list of objects", path);
  std::vector<Colourway> colourways;
  for (size_t i = 0; i < value.size() && i <= kMaxKinds; ++i) {
    const FieldPath here = path.at(i);
    ObjectReader reader(std::move(value[i]), here);
    Colourway& colourway = colourways.emplace_back();
    reader.takeFields(colourway);
    if (const std::optional<json> colours = reader.take("absorption_per_mm")) {
      const FieldPath there = here.at("absorption_per_mm");
      readList(*colours, "a list of colours, one a fibre", there);
      for (size_t k = 0; k < colours->size() && k <= kMaxKinds; ++k)
        read((*colours)[k], fieldInfo(&Fibre::absorption_per_mm), there.at(k),
             colourway.absorption_per_mm.emplace_back());
    }
    colourway.unknown = reader.rest();
  }
  return colourways;
}

std::vector<int> readWholes(const json& value, int most, const char* expected, const FieldPath& path) {
  const json::array_t& list = readList(value, expected, path);
  std::vector<int> numbers;
  numbers.reserve(list.size());
  for (size_t i = 0; i < list.size(); ++i) numbers.push_back(readWhole(list[i], 0, most, path.at(i)));
  return numbers;
}

std::vector<int> readSequence(const json& value, const FieldPath& path) {
  return readWholes(value, kMaxKinds - 1, "a list of yarn numbers", path);
}

MillData readMill(json value, const FieldPath& path) {
  ObjectReader reader(std::move(value), path);
  MillData mill;
  reader.takeFields(mill);
  if (const auto v = reader.take("ends_per_dent"))
    mill.endsPerDent = readWholes(*v, MillData::kMostInDent, "a list of numbers of ends", path.at("ends_per_dent"));
  mill.unknown = reader.rest();
  return mill;
}

Weave readWeave(const json& value, const FieldPath& path) {
  const json::array_t& list = readList(value, "a list of texts, one a pick", path);
  if (list.empty() || list.size() > static_cast<size_t>(Weave::kMaxSide))
    path.reject(fmt::format("from 1 to {} picks", Weave::kMaxSide), fmt::format("{}", list.size()));
  size_t ends = 0;
  std::vector<Weave::SharedRow> rows(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    const FieldPath here = path.at(i);
    if (!list[i].is_string()) here.reject("a text of \"#\" and \".\"", shown(list[i]));
    const std::string& text = list[i].get_ref<const std::string&>();
    if (i == 0) {
      ends = text.size();
      if (ends < 1 || ends > static_cast<size_t>(Weave::kMaxSide))
        here.reject(fmt::format("from 1 to {} ends", Weave::kMaxSide), fmt::format("{}", ends));
    }
    if (text.size() != ends)
      here.reject(fmt::format("{} ends as in the first pick listed", ends), fmt::format("{}", text.size()));
    if (const size_t wrong = text.find_first_not_of("#."); wrong != std::string::npos)
      here.reject("only \"#\" (warp over) and \".\" (weft over)",
                  fmt::format("{} at {}", quotedText(text.substr(wrong, 1)), wrong + 1));
    Weave::Row row(ends);
    for (size_t e = 0; e < ends; ++e) row[e] = text[e] == '#' ? 1 : 0;
    rows[list.size() - 1 - i] = std::make_shared<const Weave::Row>(std::move(row));
  }
  return Weave(std::move(rows));
}

/// Entries of a draft: a number or a list of numbers each.
NumberLists readDraftList(const json& value, const FieldPath& path) {
  const json::array_t& list = readList(value, "a list of numbers, or of lists of numbers", path);
  NumberLists entries(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    const FieldPath here = path.at(i);
    const double most = fieldInfo(&Draft::shafts).max;
    if (list[i].is_array()) {
      for (size_t j = 0; j < list[i].size(); ++j) entries[i].push_back(readWhole(list[i][j], 0, most, here.at(j)));
    } else {
      entries[i].push_back(readWhole(list[i], 0, most, here));
    }
  }
  return entries;
}

Draft readDraft(json value, const FieldPath& path) {
  ObjectReader reader(std::move(value), path);
  Draft draft;
  reader.takeFields(draft);
  const auto list = [&](const char* key, NumberLists& entries) {
    if (const std::optional<json> found = reader.take(key)) entries = readDraftList(*found, path.at(key));
  };
  list("threading", draft.threading);
  list("tie_up", draft.tieUp);
  list("treadling", draft.treadling);
  list("liftplan", draft.liftplan);
  draft.unknown = reader.rest();
  validateDraft(draft, path);
  return draft;
}

/// What a WIF draft said, in its own syntax, line by line. Nobody but us writes it, so it has to be right.
WifRest readWifLines(const json& value, const std::string& source, const FieldPath& path) {
  std::string text;
  for (const json& line : readList(value, "a list of texts, the lines of a WIF draft", path)) {
    if (!line.is_string()) path.reject("texts", shown(line));
    text += line.get_ref<const std::string&>();
    text += '\n';
  }
  if (text.size() > kMaxWifBytes)
    path.reject(fmt::format("at most {} bytes", kMaxWifBytes), fmt::format("{}", text.size()));
  if (text.find('\0') != std::string::npos) path.reject("texts", "one with a NUL character");
  WifWarnings warnings;
  WifRest rest =
      readWifRest(parseWifSections(text, fmt::format("{}: {}", source, path.text()), warnings), {}, warnings);
  const std::vector<WifWarning> complaints = warnings.list();
  if (!complaints.empty()) path.reject("lines as in a WIF draft", inOneLine(complaints.front()));
  return rest;
}

std::shared_ptr<const WifOrigin> readOrigin(json value, const std::string& source, const FieldPath& path) {
  ObjectReader reader(std::move(value), path);
  auto origin = std::make_shared<WifOrigin>();
  reader.takeFields(*origin);
  const auto diameters = [&](const char* key, const FieldInfo& info, std::vector<double>& out) {
    const std::optional<json> list = reader.take(key);
    if (!list) return;
    const FieldPath here = path.at(key);
    out.resize(readList(*list, "a list of numbers", here).size());
    for (size_t i = 0; i < out.size(); ++i) read((*list)[i], info, here.at(i), out[i]);
  };
  diameters("warp_diameters_mm", fieldInfo(&WifOrigin::warpDiameter_mm), origin->warpDiameters_mm);
  diameters("weft_diameters_mm", fieldInfo(&WifOrigin::weftDiameter_mm), origin->weftDiameters_mm);
  if (auto yarns = reader.take("yarns")) origin->yarns = readObjects<WifYarn>(std::move(*yarns), path.at("yarns"));
  if (const std::optional<json> lines = reader.take("lines"))
    origin->rest = readWifLines(*lines, source, path.at("lines"));
  origin->unknown = reader.rest();
  return origin;
}

void checkVersion(const std::optional<json>& version, const FieldPath& path) {
  if (!version) path.reject(fmt::format("{}, as in every fabric file", kFabricVersion), "nothing");
  if (readWhole(*version, 1, 1e9, path) > kFabricVersion)
    path.reject(fmt::format("at most {}", kFabricVersion),
                version->dump() + ": a newer Loomlight wrote this file, and is needed to read it");
}

/// Loomlight writes every key, people those that they need, of which the camera's target is none: a file with that and
/// without a later key is older than this.
bool isOlderThanPressing(const ObjectReader& reader) {
  return !reader.has("press") && reader.has("camera", "target_mm");
}

}  // namespace

FabricReading fabricReadingOf(std::string_view text, const std::string& sourceName) {
  const FieldPath path(sourceName);
  ObjectReader reader(parseJson(text, sourceName), path);
  checkVersion(reader.take("loomlight_version"), path.at("loomlight_version"));

  FabricReading reading;
  Fabric& fabric = reading.fabric;
  if (isOlderThanPressing(reader))
    reading.remarks.push_back(
        fmt::format("The file is older than the pressing of yarns: it opens pressed by {:g}, as finished cloth is, "
                    "thinner and less crimped than it was drawn then.",
                    fabric.press));
  reader.takeFields(fabric);
  const std::optional<json> weave = reader.take("weave");
  if (weave) fabric.weave = readWeave(*weave, path.at("weave"));
  if (std::optional<json> draft = reader.take("draft")) {
    fabric.draft = readDraft(std::move(*draft), path.at("draft"));
    if (!weave) fabric.weave = drawdown(*fabric.draft);
  }
  if (auto v = reader.take("warp_sequence")) fabric.warpSequence = readSequence(*v, path.at("warp_sequence"));
  if (auto v = reader.take("weft_sequence")) fabric.weftSequence = readSequence(*v, path.at("weft_sequence"));
  if (auto v = reader.take("yarns")) fabric.yarns = readObjects<Yarn>(std::move(*v), path.at("yarns"));
  if (auto v = reader.take("fibres")) fabric.fibres = readObjects<Fibre>(std::move(*v), path.at("fibres"));
  if (auto v = reader.take("colourways")) fabric.colourways = readColourways(std::move(*v), path.at("colourways"));
  if (auto v = reader.take("mill")) fabric.mill = readMill(std::move(*v), path.at("mill"));
  if (auto v = reader.take("drape")) fabric.drape = readObject<Drape>(std::move(*v), path.at("drape"));
  if (auto v = reader.take("light")) fabric.light = readObject<Light>(std::move(*v), path.at("light"));
  if (auto v = reader.take("camera")) fabric.camera = readObject<Camera>(std::move(*v), path.at("camera"));
  if (auto v = reader.take("render")) fabric.render = readObject<RenderSettings>(std::move(*v), path.at("render"));
  if (auto v = reader.take("wif")) fabric.wif = readOrigin(std::move(*v), sourceName, path.at("wif"));
  fabric.unknown = reader.rest();
  validate(fabric, sourceName);
  return reading;
}

Fabric fabricFromJson(std::string_view text, const std::string& sourceName) {
  return fabricReadingOf(text, sourceName).fabric;
}

}  // namespace loomlight
