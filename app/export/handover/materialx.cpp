#include "app/export/handover/materialx.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/export/handover/side_pixels.h"

namespace loomlight {
namespace {

/// The pictures, and from those of reflected and transmitted light how the surface splits them (splitColour()).
constexpr const char* kGraph = R"(  <nodegraph name="NG_cloth">
    <image name="reflected" type="color3">
      <input name="file" type="filename" value="{base}" colorspace="srgb_texture" />
    </image>
    <image name="through" type="color3">
      <input name="file" type="filename" value="{transmitted}" colorspace="srgb_texture" />
    </image>
    <image name="opacity" type="float">
      <input name="file" type="filename" value="{opacity}" />
    </image>
    <image name="height" type="float">
      <input name="file" type="filename" value="{height}" />
    </image>
    <image name="rotation" type="float">
      <input name="file" type="filename" value="{rotation}" />
    </image>
    <image name="slopes" type="vector3">
      <input name="file" type="filename" value="{normal}" />
    </image>
    <separate3 name="channels" type="multioutput">
      <input name="in" type="color3" nodename="through" />
    </separate3>
    <max name="red_green" type="float">
      <input name="in1" type="float" nodename="channels" output="outr" />
      <input name="in2" type="float" nodename="channels" output="outg" />
    </max>
    <max name="share" type="float">
      <input name="in1" type="float" nodename="red_green" />
      <input name="in2" type="float" nodename="channels" output="outb" />
    </max>
    <clamp name="share_below_one" type="float">
      <input name="in" type="float" nodename="share" />
      <input name="low" type="float" value="0.0001" />
      <input name="high" type="float" value="0.99" />
    </clamp>
    <subtract name="rest" type="float">
      <input name="in1" type="float" value="1" />
      <input name="in2" type="float" nodename="share_below_one" />
    </subtract>
    <divide name="base" type="color3">
      <input name="in1" type="color3" nodename="reflected" />
      <input name="in2" type="float" nodename="rest" />
    </divide>
    <divide name="through_color" type="color3">
      <input name="in1" type="color3" nodename="through" />
      <input name="in2" type="float" nodename="share_below_one" />
    </divide>
    <normalmap name="normal" type="vector3">
      <input name="in" type="vector3" nodename="slopes" />
    </normalmap>
    <multiply name="angle" type="float">
      <input name="in1" type="float" nodename="rotation" />
      <input name="in2" type="float" value="6.2831853" />
    </multiply>
    <cos name="angle_cos" type="float">
      <input name="in" type="float" nodename="angle" />
    </cos>
    <sin name="angle_sin" type="float">
      <input name="in" type="float" nodename="angle" />
    </sin>
    <tangent name="across" type="vector3">
      <input name="space" type="string" value="world" />
    </tangent>
    <bitangent name="up" type="vector3">
      <input name="space" type="string" value="world" />
    </bitangent>
    <multiply name="part_across" type="vector3">
      <input name="in1" type="vector3" nodename="across" />
      <input name="in2" type="float" nodename="angle_cos" />
    </multiply>
    <multiply name="part_up" type="vector3">
      <input name="in1" type="vector3" nodename="up" />
      <input name="in2" type="float" nodename="angle_sin" />
    </multiply>
    <add name="drawn_out" type="vector3">
      <input name="in1" type="vector3" nodename="part_across" />
      <input name="in2" type="vector3" nodename="part_up" />
    </add>
    <multiply name="rise_m" type="float">
      <input name="in1" type="float" nodename="height" />
      <input name="in2" type="float" value="{range_m}" />
    </multiply>
    <add name="height_m" type="float">
      <input name="in1" type="float" nodename="rise_m" />
      <input name="in2" type="float" value="{lowest_m}" />
    </add>
    <output name="base_out" type="color3" nodename="base" />
    <output name="share_out" type="float" nodename="share_below_one" />
    <output name="through_out" type="color3" nodename="through_color" />
    <output name="opacity_out" type="float" nodename="opacity" />
    <output name="normal_out" type="vector3" nodename="normal" />
    <output name="drawn_out_out" type="vector3" nodename="drawn_out" />
    <output name="height_out" type="float" nodename="height_m" />
  </nodegraph>
)";

constexpr const char* kSurface = R"(  <open_pbr_surface name="SR_cloth" type="surfaceshader">
    <input name="base_color" type="color3" nodegraph="NG_cloth" output="base_out" />
    <input name="specular_weight" type="float" value="{specular}" />
    <input name="specular_ior" type="float" value="1.5" />
    <input name="specular_roughness" type="float" value="{roughness}" />
    <input name="specular_roughness_anisotropy" type="float" value="{anisotropy}" />
    <input name="subsurface_weight" type="float" nodegraph="NG_cloth" output="share_out" />
    <input name="subsurface_color" type="color3" nodegraph="NG_cloth" output="through_out" />
    <input name="subsurface_scatter_anisotropy" type="float" value="1" />
    <input name="fuzz_weight" type="float" value="{fuzz}" />
    <input name="fuzz_color" type="color3" value="{red}, {green}, {blue}" />
    <input name="fuzz_roughness" type="float" value="{fuzz_roughness}" />
    <input name="geometry_opacity" type="float" nodegraph="NG_cloth" output="opacity_out" />
    <input name="geometry_thin_walled" type="boolean" value="true" />
    <input name="geometry_normal" type="vector3" nodegraph="NG_cloth" output="normal_out" />
    <input name="geometry_tangent" type="vector3" nodegraph="NG_cloth" output="drawn_out_out" />
  </open_pbr_surface>
  <displacement name="SD_cloth" type="displacementshader">
    <input name="displacement" type="float" nodegraph="NG_cloth" output="height_out" />
    <input name="scale" type="float" value="1" />
  </displacement>
  <surfacematerial name="cloth" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SR_cloth" />
    <input name="displacementshader" type="displacementshader" nodename="SD_cloth" />
  </surfacematerial>
)";

/// Mean over the pixels that are not holes.
float meanAnisotropy(const DigitalSide& side) {
  double sum = 0, weight = 0;
  for (size_t i = 0; i < side.maps.tile.opacity.size(); ++i) {
    const float opacity = side.maps.tile.opacity[i];
    sum += opacity * sidePixel(side, i).anisotropy;
    weight += opacity;
  }
  return weight > 0 ? static_cast<float>(sum / weight) : 0.0f;
}

}  // namespace

std::string materialXText(const DigitalCloth& cloth, ClothSide which, const SideTextures& textures) {
  using fmt::arg;
  const DigitalSide& side = cloth.of(which);
  const Principled& surface = side.fit.surface;
  const DisneyGloss gloss = openPbrGloss(surface.roughness, meanAnisotropy(side));
  const float fuzz = std::max({surface.sheenColour.r, surface.sheenColour.g, surface.sheenColour.b});
  const Rgb colour = fuzz > 0 ? surface.sheenColour / fuzz : Rgb(1);
  std::string text = "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n";
  text += fmt::format("  <!-- One tile is {:.4f} x {:.4f} mm; displacement is in metres. -->\n", cloth.width_mm(),
                      cloth.height_mm());
  text += fmt::format(fmt::runtime(kGraph), arg("base", textures.base), arg("transmitted", textures.transmitted),
                      arg("opacity", textures.opacity), arg("height", textures.height),
                      arg("rotation", textures.anisotropyRotation), arg("normal", textures.normal),
                      arg("range_m", 1e-3f * (textures.highest_mm - textures.lowest_mm)),
                      arg("lowest_m", 1e-3f * textures.lowest_mm));
  text += fmt::format(fmt::runtime(kSurface), arg("specular", openPbrSpecular(surface).value),
                      arg("roughness", gloss.roughness), arg("anisotropy", gloss.anisotropy), arg("fuzz", fuzz),
                      arg("red", colour.r), arg("green", colour.g), arg("blue", colour.b),
                      arg("fuzz_roughness", surface.sheenRoughness));
  return text + "</materialx>\n";
}

}  // namespace loomlight
