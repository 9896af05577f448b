#include "core/fabric/json/fabric_schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/wif_origin.h"

namespace loomlight {
namespace {

using nlohmann::json;

const json& schema() {
  static const json parsed = json::parse(fabricSchema());
  return parsed;
}

/// Whether an object's schema has every key of its table, as it is read.
template <class Object>
void expectTable(const json& object) {
  forEachField<Object>([&](const auto& field) {
    const json& properties = object["properties"];
    ASSERT_TRUE(properties.contains(field.info.key)) << field.info.key;
    const json& described = properties[field.info.key];
    const json& type = described.contains("anyOf") ? described["anyOf"][0] : described;  // its simplest form
    EXPECT_NE(described["description"].get<std::string>().find(field.info.help), std::string::npos) << field.info.key;
    if (field.info.max > field.info.min) {
      const json& range = type.contains("items") ? type["items"] : type;
      EXPECT_EQ(range["minimum"].get<double>(), field.info.min) << field.info.key;
      EXPECT_EQ(range["maximum"].get<double>(), field.info.max) << field.info.key;
    }
    EXPECT_NE(fabricKeys().find(std::string(field.info.key) + ": "), std::string::npos) << field.info.key;
  });
}

TEST(FabricSchema, HasEveryKeyOfTheTables) {
  EXPECT_EQ(schema()["$schema"], "https://json-schema.org/draft/2020-12/schema");
  const json& properties = schema()["properties"];
  expectTable<Fabric>(schema());
  expectTable<Yarn>(properties["yarns"]["items"]);
  expectTable<Fibre>(properties["fibres"]["items"]);
  expectTable<Colourway>(properties["colourways"]["items"]);
  expectTable<Draft>(properties["draft"]);
  expectTable<MillData>(properties["mill"]);
  expectTable<Drape>(properties["drape"]);
  expectTable<Light>(properties["light"]);
  expectTable<Camera>(properties["camera"]);
  expectTable<RenderSettings>(properties["render"]);
  expectTable<WifOrigin>(properties["wif"]);
}

/// Keys of a file that the schema does not know, with their paths.
std::vector<std::string> unknownIn(const json& value, const json& type, const std::string& path) {
  std::vector<std::string> unknown;
  const auto add = [&](const std::vector<std::string>& more) {
    unknown.insert(unknown.end(), more.begin(), more.end());
  };
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      if (!type.value("properties", json::object()).contains(key))
        unknown.push_back(path + "/" + key);
      else
        add(unknownIn(inner, type["properties"][key], path + "/" + key));
    }
  }
  if (value.is_array() && type.contains("items"))
    for (const json& inner : value) add(unknownIn(inner, type["items"], path));
  return unknown;
}

// Whatever is written beyond the tables: lists, drafts, what came from a WIF draft.
TEST(FabricSchema, HasEveryKeyThatIsWritten) {
  Fabric fabric;
  fabric.weave = Weave(std::vector<Weave::Row>{{1, 0}, {0, 1}});
  Draft draft;
  draft.shafts = 2;
  draft.threading = {{1}, {2}};
  draft.liftplan = {{1}, {2}};
  fabric.draft = draft;
  fabric.colourways = {{}};
  fabric.colourways[0].absorption_per_mm.resize(fabric.fibres.size());
  fabric.yarns[0].blendFibre = 0;
  fabric.yarns[0].fibresPerPly = 30;
  WifOrigin origin;
  origin.warpDiameters_mm = origin.weftDiameters_mm = {0.2, 0.4};
  fabric.wif = std::make_shared<WifOrigin>(origin);
  EXPECT_EQ(unknownIn(json::parse(fabricToJson(fabric)), schema(), ""), std::vector<std::string>{});
}

TEST(FabricSchema, TellsTheDefaultsAndChoices) {
  const json& yarn = schema()["properties"]["yarns"]["items"]["properties"];
  EXPECT_EQ(yarn["plies"]["default"], Yarn{}.plies);
  EXPECT_EQ(yarn["layout"]["enum"], (json{"random", "packed"}));
  EXPECT_FALSE(yarn["blend_fibre"].contains("default")) << "left out, there is no blend";
  EXPECT_EQ(schema()["required"], json{"loomlight_version"});
}

}  // namespace
}  // namespace loomlight
