#include "app/export/handover/u3m.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/export/handover/cloth_facts.h"
#include "app/export/handover/fit_json.h"
#include "app/export/handover/side_pixels.h"
#include "core/base/checksum.h"
#include "core/base/rgb.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/json/json_text.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

/// Version 4, variant 1, of the fabric's own bits.
std::string idOf(const Fabric& fabric) {
  const std::string text = fabricToJson(fabric);
  uint64_t high = hashBytes(0, text), low = hashBytes(1, text);
  high = (high & ~uint64_t{0xF000}) | 0x4000;
  low = (low & ~(uint64_t{3} << 62)) | uint64_t{2} << 62;
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:012x}", high >> 32, high >> 16 & 0xFFFF, high & 0xFFFF, low >> 48,
                     low & 0xFFFF'FFFF'FFFF);
}

Json encodedColour(const Rgb& encoded) {
  return {{"r", std::clamp(encoded.r, 0.0f, 1.0f)},
          {"g", std::clamp(encoded.g, 0.0f, 1.0f)},
          {"b", std::clamp(encoded.b, 0.0f, 1.0f)}};
}

Json constant(const Json& value) {
  return {{"constant", value}, {"texture", nullptr}};
}

/// One side's parameters.
class Visualisation {
 public:
  Visualisation(const DigitalCloth& cloth, const DigitalSide& side, const SideTextures& textures)
      : cloth_(cloth), side_(side), textures_(textures) {}

  Json json() const {
    const SideTextures::Means& means = textures_.means;
    const Principled& surface = side_.fit.surface;
    const Json flat = {{"x", 0}, {"y", 0}, {"z", 1}};
    Json normal = constant(flat);
    normal["texture"] = {{"scale", 1}, {"image", image(textures_.normal)}};
    Json base = constant(encodedColour(srgbFromLinear(means.base)));
    base["texture"] = {{"mode", "multiply"}, {"factor", encodedColour(Rgb(1))}, {"image", image(textures_.base)}};
    return {{"alpha", scalar(means.opacity, textures_.opacity)},
            {"anisotropy_value", scalar(means.anisotropy, textures_.anisotropy)},
            {"anisotropy_rotation", scalar(means.anisotropyRotation, textures_.anisotropyRotation)},
            {"clearcoat_value", constant(0)},
            {"clearcoat_normal", constant(flat)},
            {"clearcoat_roughness", constant(0)},
            {"ior", constant(1.5)},
            {"metalness", constant(0)},
            {"normal", normal},
            {"displacement", scalar(means.height, textures_.height)},
            {"roughness", scalar(means.roughness, textures_.roughness)},
            {"sheen_value", constant(disneySheen(surface).value)},
            {"sheen_tint", constant(0)},
            {"specular_value", constant(disneySpecular(surface).value)},
            {"specular_tint", constant(0)},
            {"subsurface_radius", constant(0)},
            {"subsurface_value", constant(0)},
            // That of a clear body, which cloth is not: its diffuse transmission is in the custom section.
            {"transmission", constant(0)},
            {"basecolor", base},
            {"subsurface_color", constant(encodedColour(Rgb(1)))},
            {"shader", "principled"},
            {"preview", nullptr}};
  }

 private:
  Json image(const std::string& file) const {
    return {{"path", file},
            {"width", cloth_.width_mm()},
            {"height", cloth_.height_mm()},
            {"dpi", {{"x", cloth_.dpiX()}, {"y", cloth_.dpiY()}}},
            {"repeat", {{"mode", "normal"}, {"rotation", 0}}}};
  }
  Json scalar(float mean, const std::string& file) const {
    return {{"constant", mean}, {"texture", {{"factor", 1}, {"offset", 0}, {"image", image(file)}}}};
  }

  const DigitalCloth& cloth_;
  const DigitalSide& side_;
  const SideTextures& textures_;
};

Json listed(const ListedName& name) {
  return {{"type", name.type}, {"name", name.name.empty() ? Json(nullptr) : Json(name.name)}};
}

Json physicsOf(const DigitalCloth& cloth) {
  Json parts = Json::array();
  for (const CompositionPart& part : compositionOf(cloth.fabric, cloth.measures)) {
    Json json = {{"ratio", std::min(1.0, part.ratio)}};
    json.update(listed(part.fibre));
    parts.push_back(json);
  }
  return {{"thickness", cloth.measures.thickness_mm},
          {"weight", cloth.measures.arealMass_g_m2},
          {"devices", {{"fab", "null"}}},
          {"composition", {{"parts", parts}}},
          {"material_type", listed({"Woven", ""})},
          {"construction", listed(constructionOf(cloth.fabric.weave))}};
}

}  // namespace

std::string u3mText(const DigitalCloth& cloth, const SideTextures& front, const SideTextures& back,
                    std::chrono::sys_seconds now) {
  const std::string time = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(now)));
  const Json json = {
      {"schema", "1.1"},
      {"material",
       {{"id", idOf(cloth.fabric)},
        {"name", cloth.fabric.name.empty() ? "cloth" : cloth.fabric.name},
        {"description", cloth.fabric.description},
        {"created", time},
        {"modified", time},
        {"front", Visualisation(cloth, cloth.front, front).json()},
        {"back", Visualisation(cloth, cloth.back, back).json()},
        {"side", nullptr},
        {"physics", physicsOf(cloth)},
        {"metadata", nullptr}}},
      {"custom", {{"loomlight", {{"front", sideJson(cloth.front, front)}, {"back", sideJson(cloth.back, back)}}}}}};
  return jsonText(json, 2) + "\n";
}

}  // namespace loomlight
