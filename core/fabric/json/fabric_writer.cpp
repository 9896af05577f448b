#include <fmt/format.h>

#include <cstdlib>
#include <optional>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/wif/wif_writer.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(double value) {
  return value;
}
Json toJson(int value) {
  return value;
}
Json toJson(uint64_t value) {
  return value;
}
Json toJson(bool value) {
  return value;
}
Json toJson(const std::string& value) {
  return value;
}
Json toJson(const std::optional<int>& value) {
  return value ? Json(*value) : Json();
}
Json toJson(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}
Json toJson(const glm::dvec3& value) {
  return Json::array({value.x, value.y, value.z});
}
/// As the shortest decimal that gives the same float: 0.3, not 0.30000001192092896.
double decimal(float value) {
  return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}
Json toJson(const Rgb& value) {
  return Json::array({decimal(value.x), decimal(value.y), decimal(value.z)});
}
Json toJson(const Spectrum& value) {
  Json json = Json::array();
  for (const float band : value) json.push_back(decimal(band));
  return json;
}
template <class Object>
void addFields(Json& json, const Object& object);
Json toJson(const Absorption& value) {
  if (!value.isSpectral()) return toJson(value.primaries);
  Json json = Json::object();
  if (value.primaries != Rgb(0)) json["primaries"] = toJson(value.primaries);
  if (value.bands) json["bands"] = toJson(*value.bands);
  for (const Dyestuff& dye : value.dyes) addFields(json["dyes"].emplace_back(Json::object()), dye);
  return json;
}
template <class Enum>
Json toJson(Enum value)
  requires std::is_enum_v<Enum>
{
  return choiceName(value);
}

template <class Object>
void addFields(Json& json, const Object& object) {
  forEachField<Object>([&](const auto& field) {
    Json value = toJson(object.*field.member);
    if (!value.is_null()) json[field.info.key] = std::move(value);
  });
}

void addUnknown(Json& json, const UnknownKeys& unknown) {
  if (unknown) json.update(Json::parse(*unknown));
}

template <class Object>
Json objectToJson(const Object& object) {
  Json json = Json::object();
  addFields(json, object);
  addUnknown(json, object.unknown);
  return json;
}

template <class Object>
Json listToJson(const std::vector<Object>& objects) {
  Json json = Json::array();
  for (const Object& object : objects) json.push_back(objectToJson(object));
  return json;
}

Json colourwaysToJson(const std::vector<Colourway>& colourways) {
  Json json = Json::array();
  for (const Colourway& colourway : colourways) {
    Json item = Json::object();
    addFields(item, colourway);
    item["absorption_per_mm"] = Json::array();
    for (const Absorption& absorption : colourway.absorption_per_mm)
      item["absorption_per_mm"].push_back(toJson(absorption));
    addUnknown(item, colourway.unknown);
    json.push_back(std::move(item));
  }
  return json;
}

Json millToJson(const MillData& mill) {
  Json json = Json::object();
  addFields(json, mill);
  json["ends_per_dent"] = mill.endsPerDent;
  addUnknown(json, mill.unknown);
  return json;
}

Json weaveToJson(const Weave& weave) {
  Json json = Json::array();
  for (int p = weave.picks() - 1; p >= 0; --p) {
    std::string text;
    text.reserve(static_cast<size_t>(weave.ends()));
    for (const uint8_t cell : weave.row(p)) text += cell ? '#' : '.';
    json.push_back(std::move(text));
  }
  return json;
}

Json draftListToJson(const NumberLists& list) {
  Json json = Json::array();
  for (const std::vector<int>& entry : list) json.push_back(entry.size() == 1 ? Json(entry[0]) : Json(entry));
  return json;
}

Json draftToJson(const Draft& draft) {
  Json json = Json::object();
  addFields(json, draft);
  json["threading"] = draftListToJson(draft.threading);
  json["tie_up"] = draftListToJson(draft.tieUp);
  json["treadling"] = draftListToJson(draft.treadling);
  json["liftplan"] = draftListToJson(draft.liftplan);
  addUnknown(json, draft.unknown);
  return json;
}

Json originToJson(const WifOrigin& origin) {
  Json json = Json::object();
  addFields(json, origin);
  if (!origin.warpDiameters_mm.empty()) json["warp_diameters_mm"] = origin.warpDiameters_mm;
  if (!origin.weftDiameters_mm.empty()) json["weft_diameters_mm"] = origin.weftDiameters_mm;
  if (!origin.warpSpacing.empty()) json["warp_spacing"] = origin.warpSpacing;
  if (!origin.weftSpacing.empty()) json["weft_spacing"] = origin.weftSpacing;
  if (!origin.yarns.empty()) json["yarns"] = listToJson(origin.yarns);
  json["lines"] = wifRestLines(origin.rest);
  addUnknown(json, origin.unknown);
  return json;
}

}  // namespace

std::string fabricToJson(const Fabric& fabric) {
  Json json = Json::object();
  json["loomlight_version"] = kFabricVersion;
  addFields(json, fabric);
  json["warp_sequence"] = fabric.warpSequence;
  json["weft_sequence"] = fabric.weftSequence;
  if (!fabric.warpSpacing.empty()) json["warp_spacing"] = fabric.warpSpacing;
  if (!fabric.weftSpacing.empty()) json["weft_spacing"] = fabric.weftSpacing;
  json["yarns"] = listToJson(fabric.yarns);
  json["fibres"] = listToJson(fabric.fibres);
  if (!fabric.colourways.empty()) json["colourways"] = colourwaysToJson(fabric.colourways);
  if (fabric.mill != MillData{} || fabric.mill.unknown) json["mill"] = millToJson(fabric.mill);
  json["drape"] = objectToJson(fabric.drape);
  json["light"] = objectToJson(fabric.light);
  json["camera"] = objectToJson(fabric.camera);
  json["render"] = objectToJson(fabric.render);
  if (fabric.wif) json["wif"] = originToJson(*fabric.wif);
  // The draft alone says all; both could be edited apart by hand. Last, because a jacquard's is long.
  if (fabric.draft) {
    json["draft"] = draftToJson(*fabric.draft);
  } else {
    json["weave"] = weaveToJson(fabric.weave);
  }
  addUnknown(json, fabric.unknown);
  return formatJson(json);
}

}  // namespace loomlight
