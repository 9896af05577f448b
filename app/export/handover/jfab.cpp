#include "app/export/handover/jfab.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/export/handover/cloth_facts.h"
#include "core/fabric/json/json_text.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

/// Texts stand twice, the second time for readers that know UTF-8.
void putText(Json& to, const std::string& key, const std::string& text) {
  to[key] = text;
  to[key + "UTF8"] = text;
}

/// As labels have it: "70% Wool, 30% Silk".
std::string contentOf(const DigitalCloth& cloth) {
  std::string content;
  for (const CompositionPart& part : compositionOf(cloth.fabric, cloth.measures))
    content += fmt::format("{}{:.0f}% {}", content.empty() ? "" : ", ", 100 * part.ratio,
                           part.fibre.name.empty() ? part.fibre.type : part.fibre.name);
  return content;
}

}  // namespace

std::string jfabText(const DigitalCloth& cloth, const SideTextures& front) {
  constexpr double kM2_mm2 = 1e6;
  const std::string name = cloth.fabric.name.empty() ? "cloth" : cloth.fabric.name;
  Json texture = {{"v2Size", {cloth.width_mm(), cloth.height_mm()}}, {"v2Translation", {0, 0}}, {"fSignedAngle", 0}};
  putText(texture, "qsFileName", front.base);
  // What is left out, how it stretches and bends, CLO sets to its own defaults.
  Json physical = {{"fDensity", cloth.measures.arealMass_g_m2 / kM2_mm2}, {"fThickness", cloth.measures.thickness_mm}};
  putText(physical, "qsPhysicalPropertyName", name);
  Json json = {{"uiVersion", 100}, {"uiFabricVersion", 100}};
  putText(json, "qsFabricName", name);
  putText(json, "fabricContent", contentOf(cloth));
  json["mapPhysical"] = physical;
  json["mapMaterial2D"] = {
      {"listFaceMaterial", Json::array({{{"v3BaseColor", {1, 1, 1}}, {"listTexture", Json::array({texture})}}})}};
  return jsonText(json, 2) + "\n";
}

}  // namespace loomlight
