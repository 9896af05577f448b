// The schema of fabric files: the plain values of every object come from its field table, and what is said here is only
// how objects and lists lie in one another. The reference of keys is read off the schema.
#include "core/fabric/json/fabric_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/fabric/json/band_samples.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/wif_origin.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

Json described(Json schema, const std::string& text) {
  schema["description"] = text;
  return schema;
}

Json ranged(const char* type, double min, double max) {
  // As whole numbers where they are: 1e4 would be read as one that is not.
  const auto number = [](double bound) {
    return bound == std::floor(bound) && std::abs(bound) < 1e15 ? Json(static_cast<int64_t>(bound)) : Json(bound);
  };
  return {{"type", type}, {"minimum", number(min)}, {"maximum", number(max)}};
}

Json listOf(Json items, const std::string& text, size_t fewest = 0, size_t most = 0) {
  Json list{{"type", "array"}, {"items", std::move(items)}};
  if (fewest > 0) list["minItems"] = fewest;
  if (most > 0) list["maxItems"] = most;
  return described(std::move(list), text);
}

// What a value looks like, by its type; and its default, if it has one.
Json typeOf(const FieldInfo& info, double value) {
  Json type = ranged("number", info.min, info.max);
  type["default"] = value;
  return type;
}
Json typeOf(const FieldInfo& info, int value) {
  Json type = ranged("integer", info.min, info.max);
  type["default"] = value;
  return type;
}
Json typeOf(const FieldInfo& info, const std::optional<double>&) {
  return ranged("number", info.min, info.max);
}
Json typeOf(const FieldInfo& info, const std::optional<int>&) {
  return ranged("integer", info.min, info.max);
}
Json typeOf(const FieldInfo&, uint64_t value) {
  return {{"type", "integer"}, {"minimum", 0}, {"maximum", std::numeric_limits<uint64_t>::max()}, {"default", value}};
}
Json typeOf(const FieldInfo&, bool value) {
  return {{"type", "boolean"}, {"default", value}};
}
Json typeOf(const FieldInfo&, const std::string&) {
  return {{"type", "string"}};
}
template <class Vector>
  requires(Vector::length() == 3)
Json typeOf(const FieldInfo& info, const Vector&) {
  return {{"type", "array"}, {"items", ranged("number", info.min, info.max)}, {"minItems", 3}, {"maxItems", 3}};
}
/// A number for each band, or an object that says where its samples lie.
Json typeOf(const FieldInfo& info, const Spectrum&) {
  const Json number = ranged("number", info.min, info.max);
  const std::string text =
      fmt::format("{} numbers, from {} to {} nm.", kBands, kFirstBand_nm, bandWavelength_nm(kBands - 1));
  Json samples{
      {"type", "object"},
      {"properties",
       {{"from_nm", ranged("number", band_samples::kFrom_nm.min, band_samples::kFrom_nm.max)},
        {"step_nm", ranged("number", band_samples::kStep_nm.min, band_samples::kStep_nm.max)},
        {"values", listOf(number, "In the order of their wavelengths.", band_samples::kFewest, band_samples::kMost)}}},
      {"required", Json::array({"values"})},
      {"additionalProperties", false}};
  return {{"anyOf", {listOf(number, text, kBands, kBands), std::move(samples)}}};
}
template <class Object>
Json objectOf(const std::string& text);
/// Three numbers, or an object with what is known beyond them.
Json typeOf(const FieldInfo& info, const Absorption& value) {
  const Json primaries = typeOf(info, value.primaries);
  Json dye = objectOf<Dyestuff>("A dye of the recipe: it adds its amount times its absorption.");
  dye["additionalProperties"] = false;
  Json object{{"type", "object"},
              {"properties",
               {{"primaries", described(primaries, "What red, green and blue light lose.")},
                {"bands", described(typeOf(info, Spectrum{}), "What each band loses, as measured.")},
                {"dyes", listOf(std::move(dye), "The dyes on the fibre.", 0, Absorption::kMostDyes)}}},
              {"additionalProperties", false}};
  return {{"anyOf", {primaries, std::move(object)}}};
}
template <class Enum>
  requires std::is_enum_v<Enum>
Json typeOf(const FieldInfo&, Enum value) {
  return {{"enum", ChoiceNames<Enum>::names}, {"default", choiceName(value)}};
}

/// An object of the plain values of a table, to which others may be added. Keys of other versions are no mistake.
template <class Object>
Json objectOf(const std::string& text) {
  Json properties = Json::object();
  const Object defaults{};
  forEachField<Object>([&](const auto& field) {
    Json type = typeOf(field.info, defaults.*field.member);
    type["title"] = field.info.label;
    const std::string unit = field.info.unit;
    properties[field.info.key] = described(std::move(type), field.info.help + (unit.empty() ? "" : " Unit: " + unit));
  });
  return described({{"type", "object"}, {"properties", std::move(properties)}}, text);
}

Json draftSchema() {
  const Json number = ranged("integer", 0, fieldInfo(&Draft::shafts).max);
  const auto entries = [&](const char* text) {
    return listOf({{"anyOf", {number, listOf(number, "Several, or none.")}}}, text);
  };
  Json draft = objectOf<Draft>("How a loom weaves it, in the place of the weave, or beside it and then in agreement.");
  Json& properties = draft["properties"];
  properties["threading"] = entries("The shafts of every end, from 1; 0 or [] for none.");
  properties["tie_up"] = entries("The shafts of every treadle.");
  properties["treadling"] = entries("The treadles of every pick.");
  properties["liftplan"] = entries("The shafts of every pick, which has the last word over tie-up and treadling.");
  return draft;
}

Json colourwaySchema() {
  Json colourway = objectOf<Colourway>("Other colours for the same cloth.");
  colourway["properties"]["absorption_per_mm"] = listOf(typeOf(fieldInfo(&Fibre::absorption_per_mm), Absorption{}),
                                                        "The absorption of every fibre, in their order.");
  return colourway;
}

Json spacingSchema(const char* text) {
  return listOf(ranged("number", kSpacingRange.min, kSpacingRange.max), text, 0, kMostSpacing);
}

Json millSchema() {
  Json mill = objectOf<MillData>("What the mill writes beside the draft. No picture depends on it.");
  Json denting = listOf(ranged("integer", 0, MillData::kMostInDent), words::endsPerDent.help, 1, MillData::kMostDents);
  denting["default"] = MillData{}.endsPerDent;
  mill["properties"]["ends_per_dent"] = std::move(denting);
  return mill;
}

Json wifSchema() {
  Json wif = objectOf<WifOrigin>("Of a fabric that came from a WIF draft: what else that said.");
  wif["properties"]["lines"] = listOf({{"type", "string"}}, "The rest of the WIF draft, as it would stand there.");
  wif["properties"]["yarns"] =
      listOf(objectOf<WifYarn>("A yarn."), "What the fabric's yarns were given, in their order.", 0, kMaxKinds);
  const auto diameters = [](const FieldInfo& info, const char* threads) {
    const std::string text =
        fmt::format("Of each {}, repeating, where the WIF draft has sizes of single ones. Unit: mm", threads);
    return listOf(ranged("number", info.min, info.max), text, 0, kMaxSequence);
  };
  wif["properties"]["warp_diameters_mm"] = diameters(fieldInfo(&WifOrigin::warpDiameter_mm), "end");
  wif["properties"]["weft_diameters_mm"] = diameters(fieldInfo(&WifOrigin::weftDiameter_mm), "pick");
  wif["properties"]["warp_spacing"] = spacingSchema("As the fabric's, which came of the WIF draft.");
  wif["properties"]["weft_spacing"] = spacingSchema("As the fabric's, which came of the WIF draft.");
  return wif;
}

Json schema() {
  const Json yarn = ranged("integer", 0, kMaxKinds - 1);
  Json pick{{"type", "string"}, {"pattern", "^[#.]+$"}, {"maxLength", Weave::kMaxSide}};
  Json fabric = objectOf<Fabric>("A woven cloth, what it lies on, and how it is looked at.");
  Json version = described(ranged("integer", 1, kFabricVersion), "The version of this format, there in every file.");
  Json properties{{"loomlight_version", std::move(version)}};
  properties.update(fabric["properties"]);
  properties["weave"] = listOf(std::move(pick),
                               "One repeat, drawn as on point paper: the first text is the last pick, and in it end 1 "
                               "is on the left; # is warp over weft, . is weft over warp.",
                               1, Weave::kMaxSide);
  properties["draft"] = draftSchema();
  properties["warp_sequence"] = listOf(yarn, "The yarn of each end, from the left, repeating: its number, from 0.");
  properties["weft_sequence"] = listOf(yarn, "The yarn of each pick, from the bottom, repeating: its number, from 0.");
  properties["warp_spacing"] = spacingSchema(words::warpSpacing.help);
  properties["weft_spacing"] = spacingSchema(words::weftSpacing.help);
  properties["yarns"] = listOf(objectOf<Yarn>("A yarn."), "The yarns, which sequences number from 0.", 1, kMaxKinds);
  properties["fibres"] = listOf(objectOf<Fibre>("A fibre."), "The fibres, which yarns number from 0.", 1, kMaxKinds);
  properties["colourways"] = listOf(colourwaySchema(), "The colourways that the fabric keeps.", 0, kMaxKinds);
  properties["mill"] = millSchema();
  properties["drape"] = objectOf<Drape>("What the cloth lies on.");
  properties["light"] = objectOf<Light>("What shines on it.");
  properties["camera"] = objectOf<Camera>("From where it is seen.");
  properties["render"] = objectOf<RenderSettings>("How its picture is made.");
  properties["wif"] = wifSchema();
  fabric["properties"] = std::move(properties);
  fabric["required"] = {"loomlight_version"};
  Json whole{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Loomlight fabric"}};
  whole.update(fabric);
  return whole;
}

/// "0.5 to 5000, or 30 where not given", or what else can be said of a value in few words.
std::string valueText(const Json& type) {
  if (type.contains("anyOf")) return valueText(type["anyOf"][0]) + "; or an object of what is known beyond them";
  std::string text;
  if (type.contains("enum")) {
    for (const Json& name : type["enum"]) text += (text.empty() ? "" : " | ") + name.get<std::string>();
  } else if (type["type"] == "array") {
    const Json& items = type["items"];
    const bool isTriple = type.value("maxItems", 0) == 3;
    text = isTriple ? "3 of " + valueText(items) : items.value("type", "") == "object" ? "list of objects" : "list";
  } else if (type.contains("minimum")) {
    text = fmt::format("{} to {}", type["minimum"].dump(), type["maximum"].dump());
  } else {
    text = type["type"] == "boolean" ? "true | false" : type["type"] == "string" ? "text" : "object";
  }
  if (!type.contains("default")) return text;
  const Json& value = type["default"];
  return text + "; " + (value.is_string() ? value.get<std::string>() : value.dump()) + " where not given";
}

void addKeys(const Json& object, int depth, std::string& text) {
  for (const auto& [key, type] : object["properties"].items()) {
    text += fmt::format("{:{}}{}: {}\n{:{}}{}\n", "", 4 * depth, key, valueText(type), "", 4 * depth + 2,
                        type["description"].get<std::string>());
    const Json& inside = type.contains("items") ? type["items"] : type;
    if (inside.contains("properties")) addKeys(inside, depth + 1, text);
  }
}

}  // namespace

std::string fabricSchema() {
  return formatJson(schema());
}

std::string fabricKeys() {
  std::string text;
  addKeys(schema(), 0, text);
  return text;
}

}  // namespace loomlight
