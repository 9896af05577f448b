#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/json/object_reader.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/thread_spacing.h"
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

using namespace from_json;

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
  const auto numbers = [&](const char* key, const FieldInfo& info) { return takeNumbers(reader, key, info, path); };
  origin->warpDiameters_mm = numbers("warp_diameters_mm", fieldInfo(&WifOrigin::warpDiameter_mm));
  origin->weftDiameters_mm = numbers("weft_diameters_mm", fieldInfo(&WifOrigin::weftDiameter_mm));
  origin->warpSpacing = numbers("warp_spacing", kSpacingRange);
  origin->weftSpacing = numbers("weft_spacing", kSpacingRange);
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
  fabric.warpSpacing = takeNumbers(reader, "warp_spacing", kSpacingRange, path);
  fabric.weftSpacing = takeNumbers(reader, "weft_spacing", kSpacingRange, path);
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
