#include "app/export/handover/fit_json.h"

#include <nlohmann/json.hpp>

#include "app/export/handover/side_pixels.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

Json colour(const Rgb& linear) {
  return Json::array({linear.r, linear.g, linear.b});
}

Json errorJson(const FitError& error) {
  return {{"mean_reflectance_factor", error.mean}, {"rms_error", error.rms}, {"rms_noise_of_measurement", error.noise}};
}

}  // namespace

Json sideJson(const DigitalSide& side, const SideTextures& textures) {
  const SurfaceFit& fit = side.fit;
  const DisneySheen sheen = disneySheen(fit.surface);
  const GlossStrength disney = disneySpecular(fit.surface), openPbr = openPbrSpecular(fit.surface);
  return {
      {"surface",
       {{"model",
         "glTF 2.0 dielectric: Lambert + GGX (anisotropic, height-correlated Smith, Schlick from 0.04 specular) + "
         "Charlie sheen (Neubelt visibility) + Lambert through it"},
        {"specular", fit.surface.specular},
        {"roughness", fit.surface.roughness},
        {"anisotropy", fit.surface.anisotropy},
        {"sheen_color_linear", colour(fit.surface.sheenColour)},
        {"sheen_roughness", fit.surface.sheenRoughness},
        {"normal_strength", fit.normalStrength},
        {"reflected_weight", colour(fit.reflectedWeight)},
        {"transmitted_weight", colour(fit.transmittedWeight)}}},
      {"fit",
       {{"reflected", errorJson(fit.reflected)},
        {"reflected_if_matt", errorJson(fit.matt)},
        {"reflected_from_afar", errorJson(fit.fromAfar)},
        {"transmitted", errorJson(fit.transmitted)},
        {"even_light_over_measured", colour(fit.evenLight)},
        {"even_light_over_measured_from_afar", colour(fit.evenLightFromAfar)},
        {"tile_over_measured", colour(side.tileOverMeasured)}}},
      {"u3m_specular",
       {{"model", "Disney 2012: Schlick from 0.08 value to 1"},
        {"value", disney.value},
        {"rms_error_of_albedo", disney.rmsError}}},
      {"materialx_specular",
       {{"model", "OpenPBR: Fresnel of a body that reflects 0.04 value at the normal"},
        {"value", openPbr.value},
        {"rms_error_of_albedo", openPbr.rmsError}}},
      {"u3m_sheen",
       {{"model", "Disney 2012, white: value (1 - cos)^5"},
        {"value", sheen.value},
        {"rms_error_of_albedo", sheen.rmsError}}},
      {"maps",
       {{"base", {{"file", textures.base}, {"encoding", "sRGB"}}},
        {"transmitted", {{"file", textures.transmitted}, {"encoding", "sRGB"}}},
        {"normal", {{"file", textures.normal}, {"encoding", "linear, y up (OpenGL)"}}},
        {"height", {{"file", textures.height}, {"black_mm", textures.lowest_mm}, {"white_mm", textures.highest_mm}}},
        {"roughness", {{"file", textures.roughness}, {"encoding", "linear, Disney"}}},
        {"anisotropy", {{"file", textures.anisotropy}, {"encoding", "linear, Disney"}}},
        {"anisotropy_rotation",
         {{"file", textures.anisotropyRotation},
          {"encoding", "linear, 1 is 360 degrees from +x towards +y; the axis along which highlights are long"}}},
        {"opacity", {{"file", textures.opacity}, {"encoding", "linear"}}}}}};
}

}  // namespace loomlight
