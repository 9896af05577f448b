// How it works. A .glb is a header, a piece of JSON and a piece of binary, both padded to four bytes. The binary holds
// the four corners (positions, normals, tangents, texture coordinates), their two triangles, and the pictures as PNG.
#include "app/export/handover/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/export/handover/side_pixels.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/fabric/json/json_text.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSwatch_mm = 100;
constexpr float kOpaque = 0.999f;  ///< mean opacity of a cloth whose holes nobody sees

static_assert(std::endian::native == std::endian::little, "glTF has the lowest byte first");

/// The binary piece, and the views that divide it.
class Binary {
 public:
  /// Number of the view.
  int add(const void* bytes, size_t count, int target = 0) {
    data_.resize((data_.size() + 3) / 4 * 4, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", count}};
    if (target != 0) view["target"] = target;
    views_.push_back(view);
    data_.append(static_cast<const char*>(bytes), count);
    return static_cast<int>(views_.size()) - 1;
  }
  const std::string& data() const { return data_; }
  const Json& views() const { return views_; }

 private:
  std::string data_;
  Json views_ = Json::array();
};

/// The pictures of the material; each is image, texture and bufferView.
class Pictures {
 public:
  Pictures(Binary& binary, const DigitalSide& side, std::string scratch)
      : binary_(binary), side_(side), scratch_(std::move(scratch)) {}

  /// `value`: red, green, blue and alpha from 0 to 1 of a pixel. A reference to it as materials have them.
  template <class Value>
  Json add(int channels, const Value& value) {
    const TileMaps& tile = side_.maps.tile;
    Pixels8 picture{tile.width, tile.height, channels, {}};
    for (size_t i = 0; i < tile.opacity.size(); ++i) {
      const glm::vec4 v = value(sidePixel(side_, i));
      for (int c = 0; c < channels; ++c) picture.bytes.push_back(byteOf(v[c]));
    }
    writePng(scratch_, picture);
    const std::string png = readFile(scratch_, std::numeric_limits<size_t>::max());
    std::filesystem::remove(scratch_);
    images_.push_back({{"mimeType", "image/png"}, {"bufferView", binary_.add(png.data(), png.size())}});
    textures_.push_back({{"sampler", 0}, {"source", images_.size() - 1}});
    return {{"index", textures_.size() - 1}};
  }
  const Json& images() const { return images_; }
  const Json& textures() const { return textures_; }

 private:
  Binary& binary_;
  const DigitalSide& side_;
  std::string scratch_;
  Json images_ = Json::array(), textures_ = Json::array();
};

glm::vec4 encoded(const Rgb& linear, float alpha) {
  return {srgbFromLinear(linear), alpha};
}

/// +1 or -1 times the axis: the end of it that lies from -45 to 135 degrees, so that neighbours agree (side_pixels.h).
glm::vec2 agreed(glm::vec2 axis) {
  return axis.x + axis.y < 0 ? -axis : axis;
}

Json materialOf(const DigitalCloth& cloth, const DigitalSide& side, Pictures& pictures) {
  const Principled& surface = side.fit.surface;
  const std::vector<float>& opacity = side.maps.tile.opacity;
  double covered = 0;
  for (const float value : opacity) covered += value;
  const bool isOpaque = covered / static_cast<double>(opacity.size()) > kOpaque;
  const Json base = pictures.add(4, [](const SidePixel& pixel) {
    return encoded(splitColour(pixel.reflected, pixel.transmitted).base, pixel.opacity);
  });
  const Json normal = pictures.add(3, [](const SidePixel& pixel) { return glm::vec4(0.5f * pixel.normal + 0.5f, 1); });
  const Json rough = pictures.add(3, [](const SidePixel& pixel) { return glm::vec4(1, pixel.roughness, 0, 1); });
  const Json gloss = pictures.add(
      3, [](const SidePixel& pixel) { return glm::vec4(0.5f * agreed(pixel.drawnOut) + 0.5f, pixel.anisotropy, 1); });
  const Json through = pictures.add(4, [](const SidePixel& pixel) {
    const SplitColour split = splitColour(pixel.reflected, pixel.transmitted);
    return encoded(split.through, split.share);
  });
  const Rgb& sheen = surface.sheenColour;
  return {
      {"name", cloth.fabric.name},
      {"doubleSided", true},
      {"alphaMode", isOpaque ? "OPAQUE" : "BLEND"},
      {"pbrMetallicRoughness",
       {{"baseColorTexture", base},
        {"metallicFactor", 0},
        {"roughnessFactor", 1},
        {"metallicRoughnessTexture", rough}}},
      {"normalTexture", normal},
      {"extensions",
       {{"KHR_materials_specular", {{"specularFactor", surface.specular}}},
        {"KHR_materials_sheen",
         {{"sheenColorFactor", Json::array({sheen.r, sheen.g, sheen.b})},
          {"sheenRoughnessFactor", surface.sheenRoughness}}},
        {"KHR_materials_anisotropy", {{"anisotropyStrength", 1}, {"anisotropyTexture", gloss}}},
        {"KHR_materials_diffuse_transmission",
         {{"diffuseTransmissionFactor", 1},
          {"diffuseTransmissionTexture", through},
          {"diffuseTransmissionColorFactor", Json::array({1, 1, 1})},
          {"diffuseTransmissionColorTexture", through}}}}},
      {"extras", {{"thickness_mm", cloth.measures.thickness_mm}, {"areal_mass_g_m2", cloth.measures.arealMass_g_m2}}}};
}

/// A vertex attribute of the four corners.
Json accessor(int view, const char* type, int count = 4, int component = 5126) {
  return {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
}

/// The accessors of the swatch: position, normal, tangent, texture coordinates, indices.
Json swatch(const DigitalCloth& cloth, Binary& binary) {
  constexpr int kVertices = 34962, kIndices = 34963;
  const auto tiles = [](double tile_mm) { return static_cast<float>(std::max(1.0, std::round(kSwatch_mm / tile_mm))); };
  const float across = tiles(cloth.width_mm()), up = tiles(cloth.height_mm());
  const auto width = static_cast<float>(1e-3 * cloth.width_mm() * across);
  const auto height = static_cast<float>(1e-3 * cloth.height_mm() * up);
  const std::array<float, 12> positions{0, 0, 0, width, 0, 0, width, height, 0, 0, height, 0};
  const std::array<float, 12> normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::array<float, 16> tangents{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  // v runs downwards from the picture's top row, which is the upper edge.
  const std::array<float, 8> places{0, up, across, up, across, 0, 0, 0};
  const std::array<uint16_t, 6> triangles{0, 1, 2, 0, 2, 3};
  const auto floats = [&](const auto& values) {
    return binary.add(values.data(), sizeof(float) * values.size(), kVertices);
  };
  Json accessors = Json::array();
  accessors.push_back(accessor(floats(positions), "VEC3"));
  accessors.back()["min"] = Json::array({0, 0, 0});
  accessors.back()["max"] = Json::array({width, height, 0});
  accessors.push_back(accessor(floats(normals), "VEC3"));
  accessors.push_back(accessor(floats(tangents), "VEC4"));
  accessors.push_back(accessor(floats(places), "VEC2"));
  const int indices = binary.add(triangles.data(), sizeof(uint16_t) * triangles.size(), kIndices);
  accessors.push_back(accessor(indices, "SCALAR", 6, 5123));
  return accessors;
}

void putPiece(std::string& to, const char* kind, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  const auto size = static_cast<uint32_t>(content.size());
  to.append(reinterpret_cast<const char*>(&size), 4).append(kind, 4) += content;
}

}  // namespace

void expectGlbSize(size_t bytes, const std::string& file) {
  if (bytes > std::numeric_limits<uint32_t>::max())
    throw InputError(fmt::format("{}: expected at most 4 GB, got {} bytes; a smaller --size helps", file, bytes));
}

std::string glbBytes(const DigitalCloth& cloth, ClothSide side, const std::string& scratch, const std::string& file) {
  Binary binary;
  Pictures pictures(binary, cloth.of(side), scratch);
  const Json material = materialOf(cloth, cloth.of(side), pictures);
  const Json accessors = swatch(cloth, binary);
  Json extensions = Json::array();
  for (const auto& [name, value] : material["extensions"].items()) extensions.push_back(name);
  const Json json = {{"asset", {{"version", "2.0"}, {"generator", "Loomlight " LOOMLIGHT_VERSION}}},
                     {"extensionsUsed", extensions},
                     {"scene", 0},
                     {"scenes", {{{"nodes", {0}}}}},
                     {"nodes", {{{"mesh", 0}, {"name", cloth.fabric.name}}}},
                     {"meshes",
                      {{{"primitives",
                         {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TANGENT", 2}, {"TEXCOORD_0", 3}}},
                           {"indices", 4},
                           {"material", 0}}}}}}},
                     {"materials", Json::array({material})},
                     {"samplers", {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}}},
                     {"textures", pictures.textures()},
                     {"images", pictures.images()},
                     {"accessors", accessors},
                     {"bufferViews", binary.views()},
                     {"buffers", {{{"byteLength", (binary.data().size() + 3) / 4 * 4}}}}};
  std::string pieces;
  putPiece(pieces, "JSON", jsonText(json), ' ');
  putPiece(pieces, "BIN\0", binary.data(), '\0');
  expectGlbSize(pieces.size() + 12, file);
  std::string glb = "glTF";
  const std::array<uint32_t, 2> head{2, static_cast<uint32_t>(pieces.size() + 12)};
  glb.append(reinterpret_cast<const char*>(head.data()), 8) += pieces;
  return glb;
}

}  // namespace loomlight
