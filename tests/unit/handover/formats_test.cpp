#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "app/export/handover/cloth_facts.h"
#include "app/export/handover/gltf.h"
#include "app/export/handover/handover.h"
#include "app/export/handover/restricted_zip.h"
#include "app/export/handover/side_pixels.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/weave/jacquard.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/handover/two_sided_cloth.h"

namespace loomlight {
namespace {

using Json = nlohmann::json;
using std::chrono::sys_days;

constexpr std::chrono::sys_seconds kNoon = sys_days(std::chrono::year(2026) / 11 / 21) + std::chrono::hours(12);

uint32_t number(const std::string& bytes, size_t at, int count) {
  uint32_t value = 0;
  for (int i = 0; i < count; ++i) value |= uint32_t{static_cast<uint8_t>(bytes[at + static_cast<size_t>(i)])} << 8 * i;
  return value;
}

/// A cloth handed over once, for all tests of its files.
class HandedOver : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Fabric fabric = test::twoSidedCloth();
    fabric.name = "two sides";
    fabric.render.samplesPerPixel = 4;
    fabric.fibres[0].name = "wool, white";
    fabric.fibres[1].name = "acme 5";
    DigitalClothOrder order;
    order.longestSide = 64;
    order.joinTwist = false;
    order.measuringSamples = 4;
    order.fitSamples = 8;
    folder = std::make_unique<test::ScratchFolder>();
    cloth = std::make_unique<DigitalCloth>(*makeDigitalCloth(fabric, order, 1e9, {}));
    report = std::make_unique<HandoverReport>(
        writeHandover(folder->path().string(), "two_sides", *cloth, kNoon, {}).value());
  }
  static void TearDownTestSuite() {
    report.reset();
    cloth.reset();
    folder.reset();
  }
  static std::string read(const std::string& file) {
    return readFile((folder->path() / file).string(), size_t{1} << 30);
  }

  struct PngFacts {
    uint64_t bits;                           ///< of a channel
    int64_t across_perMetre, down_perMetre;  ///< pixels
  };
  static PngFacts pngFacts(const std::string& file) {
    const std::string bytes = read(file);
    const size_t density = bytes.find("pHYs") + 4;
    const auto bigEndian = [&](size_t at) {
      int64_t value = 0;
      for (size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<uint8_t>(bytes.at(at + i));
      return value;
    };
    return {static_cast<uint8_t>(bytes.at(24)), bigEndian(density), bigEndian(density + 4)};
  }

  static inline std::unique_ptr<test::ScratchFolder> folder;
  static inline std::unique_ptr<DigitalCloth> cloth;
  static inline std::unique_ptr<HandoverReport> report;
};

TEST_F(HandedOver, AllFilesThatAreSaidAreThereAndNoOthers) {
  std::set<std::string> there;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder->path()))
    if (entry.is_regular_file()) there.insert(std::filesystem::relative(entry.path(), folder->path()).string());
  EXPECT_EQ(there, std::set<std::string>(report->files.begin(), report->files.end()));
  EXPECT_TRUE(there.contains("textures/two_sides_BASE.png"));
  EXPECT_TRUE(there.contains("textures/two_sides_back_NRM.png"));
}

TEST_F(HandedOver, NothingIsThereOfWhatWasStopped) {
  const test::ScratchFolder other;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(writeHandover(other.path().string(), "two_sides", *cloth, kNoon, {stop.get_token(), {}, 0}));
  EXPECT_TRUE(std::filesystem::is_empty(other.path()));
}

TEST_F(HandedOver, TheU3mHasEveryKeyOfItsVersionAndSizesThatAgree) {
  const Json u3m = Json::parse(read("two_sides.u3m"));
  EXPECT_EQ(u3m.size(), 3u);
  EXPECT_EQ(u3m["schema"], "1.1");
  const Json& material = u3m["material"];
  for (const char* key :
       {"id", "name", "description", "created", "modified", "front", "back", "side", "physics", "metadata"})
    EXPECT_TRUE(material.contains(key)) << key;
  EXPECT_EQ(material.size(), 10u);
  EXPECT_EQ(material["created"], "2026-11-21T12:00:00Z");
  EXPECT_TRUE(std::regex_match(material["id"].get<std::string>(),
                               std::regex("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")));
  for (const char* which : {"front", "back"}) {
    const Json& side = material[which];
    for (const char* key : {"alpha",
                            "anisotropy_value",
                            "anisotropy_rotation",
                            "clearcoat_value",
                            "clearcoat_normal",
                            "clearcoat_roughness",
                            "ior",
                            "metalness",
                            "normal",
                            "displacement",
                            "roughness",
                            "sheen_value",
                            "sheen_tint",
                            "specular_value",
                            "specular_tint",
                            "subsurface_radius",
                            "subsurface_value",
                            "transmission",
                            "basecolor",
                            "subsurface_color",
                            "shader",
                            "preview"})
      EXPECT_TRUE(side.contains(key)) << key;
    EXPECT_EQ(side.size(), 22u);
    for (const auto& [key, value] : side.items()) {
      if (!value.is_object() || value["texture"].is_null()) continue;
      const Json& image = value["texture"]["image"];
      const PictureExtent extent = readPngExtent((folder->path() / image["path"].get<std::string>()).string());
      EXPECT_EQ(extent.channels, 3) << key;
      EXPECT_NEAR(image["dpi"]["x"].get<double>() * image["width"].get<double>() / 25.4, extent.width, 1e-6);
      EXPECT_NEAR(image["dpi"]["y"].get<double>() * image["height"].get<double>() / 25.4, extent.height, 1e-6);
      const PngFacts png = pngFacts("textures/" + image["path"].get<std::string>().substr(9));
      EXPECT_EQ(png.across_perMetre, std::lround(image["dpi"]["x"].get<double>() / 0.0254)) << key;
      EXPECT_EQ(png.down_perMetre, std::lround(image["dpi"]["y"].get<double>() / 0.0254)) << key;
      EXPECT_NE(png.across_perMetre, png.down_perMetre) << "of this cloth the tile has other pixels across than down";
      EXPECT_EQ(png.bits, key == "basecolor" ? 8u : 16u) << key;
    }
  }
  const Json& physics = material["physics"];
  EXPECT_NEAR(physics["thickness"], cloth->measures.thickness_mm, 1e-9);
  EXPECT_NEAR(physics["weight"], cloth->measures.arealMass_g_m2, 1e-9);
  EXPECT_EQ(physics["construction"]["type"], constructionOf(cloth->fabric.weave).type);
  double sum = 0;
  for (const Json& part : physics["composition"]["parts"]) {
    sum += part["ratio"].get<double>();
    EXPECT_EQ(part["name"].is_null(), part["type"] != "other");
  }
  EXPECT_NEAR(sum, 1, 1e-9);
  EXPECT_EQ(physics["composition"]["parts"].size(), 2u);
}

TEST_F(HandedOver, TheArchiveHoldsTheSameBytesAndNothingThatItsRulesForbid) {
  const std::string zip = read("two_sides.u3ma");
  const size_t end = zip.size() - 22;
  ASSERT_EQ(number(zip, end, 4), 0x06054b50u);
  const uint32_t count = number(zip, end + 10, 2);
  EXPECT_EQ(count, 17u);
  EXPECT_EQ(number(zip, end + 20, 2), 0u);  // no comment
  size_t at = number(zip, end + 16, 4);
  EXPECT_EQ(at + number(zip, end + 12, 4), end);
  for (uint32_t i = 0; i < count; ++i) {
    ASSERT_EQ(number(zip, at, 4), 0x02014b50u);
    EXPECT_EQ(number(zip, at + 4, 2), 0x003Fu);
    EXPECT_EQ(number(zip, at + 6, 2), 0x14u);
    EXPECT_EQ(number(zip, at + 8, 2), 0x800u);
    EXPECT_EQ(number(zip, at + 10, 2), 0u);
    EXPECT_EQ(number(zip, at + 12, 2), 12u << 11);  // noon
    EXPECT_EQ(number(zip, at + 14, 2), 46u << 9 | 11u << 5 | 21u);
    for (const size_t empty : {30, 32, 34, 36, 38, 40}) EXPECT_EQ(number(zip, at + empty, 2), 0u);
    const uint32_t length = number(zip, at + 28, 2), local = number(zip, at + 42, 4), size = number(zip, at + 24, 4);
    EXPECT_EQ(zip.substr(local + 4, 26), zip.substr(at + 6, 26)) << "both headers say the same";
    const std::string path = zip.substr(at + 46, length);
    EXPECT_EQ(zip.substr(local + 30, length), path);
    EXPECT_EQ(zip.substr(local + 30 + length, size), read(path)) << path;
    at += 46 + length;
  }
  EXPECT_EQ(at, end);
}

TEST(RestrictedZip, ChecksumsAreThoseOfZip) {
  const ArchivedFile file{"a.txt", "123456789"};
  const std::string zip = restrictedZip(std::span(&file, 1), kNoon, "a.u3ma");
  EXPECT_EQ(number(zip, 14, 4), 0xCBF43926u);  // the check value of CRC-32
}

TEST(RestrictedZip, OfTooManyFilesIsRefusedByItsName) {
  const std::vector<ArchivedFile> files(65536);
  EXPECT_EQ(test::messageOf<InputError>([&] { restrictedZip(files, kNoon, "out/a.u3ma"); }),
            "out/a.u3ma: expected at most 4 GB and 65535 files, got 65536 files with 8388608 bytes");
}

/// One that is as large would need as much memory.
TEST(Glb, OfMoreThanItsHeadCanSayIsRefusedByItsName) {
  expectGlbSize(0xFFFFFFFFu, "out/a.glb");
  EXPECT_EQ(test::messageOf<InputError>([] { expectGlbSize(size_t{1} << 32, "out/a.glb"); }),
            "out/a.glb: expected at most 4 GB, got 4294967296 bytes; a smaller --size helps");
}

/// side_maps_test.cpp is about which way these normals lean.
TEST_F(HandedOver, TheNormalMapsHaveTheNormalsWithYUp) {
  for (const ClothSide which : {ClothSide::front, ClothSide::back}) {
    const char* name = which == ClothSide::front ? "two_sides_NRM.png" : "two_sides_back_NRM.png";
    const Pixels8 picture = readPng((folder->path() / "textures" / name).string());
    ASSERT_EQ(picture.channels, 3);
    ASSERT_GT(cloth->of(which).fit.normalStrength, 0);
    for (size_t i = 0; i < picture.bytes.size(); ++i) {
      const glm::vec3 normal = sidePixel(cloth->of(which), i / 3).normal;
      ASSERT_NEAR(picture.bytes[i] / 255.0, 0.5 * normal[static_cast<int>(i % 3)] + 0.5, 0.51 / 255)
          << name << ", " << i;
    }
  }
}

TEST_F(HandedOver, TheGlbIsWholeAndAtTrueSize) {
  for (const char* file : {"two_sides.glb", "two_sides_back.glb"}) {
    const std::string glb = read(file);
    ASSERT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(number(glb, 4, 4), 2u);
    EXPECT_EQ(number(glb, 8, 4), glb.size());
    const uint32_t length = number(glb, 12, 4);
    EXPECT_EQ(length % 4, 0u);
    const Json json = Json::parse(glb.substr(20, length));
    const uint32_t binary = number(glb, 20 + length, 4);
    EXPECT_EQ(28 + length + binary, glb.size());
    EXPECT_EQ(json["buffers"][0]["byteLength"], binary);
    for (const Json& view : json["bufferViews"])
      EXPECT_LE(view["byteOffset"].get<uint32_t>() + view["byteLength"].get<uint32_t>(), binary);
    for (const Json& image : json["images"]) {
      const Json& view = json["bufferViews"][image["bufferView"].get<size_t>()];
      EXPECT_EQ(glb.substr(28 + length + view["byteOffset"].get<size_t>(), 4), "\x89PNG");
    }
    // The swatch is as many tiles across as its texture coordinates say.
    const Json& places = json["bufferViews"][json["accessors"][3]["bufferView"].get<size_t>()];
    float across = 0;
    std::memcpy(&across, glb.data() + 28 + length + places["byteOffset"].get<size_t>() + 8, sizeof(across));
    EXPECT_NEAR(json["accessors"][0]["max"][0].get<double>(), 1e-3 * across * cloth->width_mm(), 1e-6);
    EXPECT_NEAR(json["accessors"][0]["max"][0].get<double>(), 0.1, 0.5e-3 * cloth->width_mm());
    for (const Json& extension : json["extensionsUsed"])
      EXPECT_TRUE(json["materials"][0]["extensions"].contains(extension.get<std::string>()));
  }
}

TEST_F(HandedOver, TheGlbHasTheSurfaceThatWasFitted) {
  for (const ClothSide which : {ClothSide::front, ClothSide::back}) {
    const std::string glb = read(which == ClothSide::front ? "two_sides.glb" : "two_sides_back.glb");
    const uint32_t length = number(glb, 12, 4);
    const Json json = Json::parse(glb.substr(20, length));
    const auto picture = [&](const Json& texture) {
      const Json& image = json["images"][json["textures"][texture["index"].get<size_t>()]["source"].get<size_t>()];
      const Json& view = json["bufferViews"][image["bufferView"].get<size_t>()];
      const std::string file = (folder->path() / "taken_out.png").string();
      writeFileAtomically(file, std::string_view(glb).substr(28 + length + view["byteOffset"].get<size_t>(),
                                                             view["byteLength"].get<size_t>()));
      Pixels8 pixels = readPng(file);
      std::filesystem::remove(file);
      return pixels;
    };
    const DigitalSide& side = cloth->of(which);
    const Principled& surface = side.fit.surface;
    const Json& extensions = json["materials"][0]["extensions"];
    EXPECT_EQ(extensions["KHR_materials_specular"]["specularFactor"], surface.specular);
    const Json& sheen = extensions["KHR_materials_sheen"];
    for (int c = 0; c < 3; ++c) EXPECT_EQ(sheen["sheenColorFactor"][static_cast<size_t>(c)], surface.sheenColour[c]);
    EXPECT_EQ(sheen["sheenRoughnessFactor"], surface.sheenRoughness);
    // What differs from pixel to pixel is in pictures alone: the factor of each is 1.
    const Json& anisotropy = extensions["KHR_materials_anisotropy"];
    const Json& through = extensions["KHR_materials_diffuse_transmission"];
    EXPECT_EQ(anisotropy["anisotropyStrength"], 1);
    EXPECT_EQ(through["diffuseTransmissionFactor"], 1);
    const Pixels8 strengths = picture(anisotropy["anisotropyTexture"]);
    const Pixels8 shares = picture(through["diffuseTransmissionTexture"]);
    ASSERT_EQ(strengths.channels, 3);
    ASSERT_EQ(shares.channels, 4);
    for (size_t i = 0; i < side.maps.tile.opacity.size(); ++i) {
      const SidePixel pixel = sidePixel(side, i);
      ASSERT_NEAR(strengths.bytes[3 * i + 2] / 255.0, pixel.anisotropy, 0.51 / 255) << i;
      ASSERT_NEAR(shares.bytes[4 * i + 3] / 255.0, splitColour(pixel.reflected, pixel.transmitted).share, 0.51 / 255)
          << i;
    }
  }
}

TEST_F(HandedOver, TheMaterialXNamesFilesThatAreThere) {
  const std::string text = read("two_sides_back.mtlx");
  const std::regex file("type=\"filename\" value=\"([^\"]*)\"");
  int found = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), file), none; i != none; ++i, ++found)
    EXPECT_TRUE(std::filesystem::exists(folder->path() / (*i)[1].str())) << (*i)[1];
  EXPECT_EQ(found, 6);
}

/// What a node of a MaterialX graph has: the tangent is along x, the bitangent along y, the rotation the same
/// everywhere.
glm::vec3 valueOf(const std::string& graph, const std::string& node, float rotation) {
  std::smatch found, input;
  const std::regex element("<(\\w+) name=\"" + node + "\" type=\"\\w+\">([^]*?)</\\1>");
  if (!std::regex_search(graph, found, element)) throw std::runtime_error("no node " + node);
  const std::string kind = found[1], inputs = found[2];
  if (kind == "image" && node == "rotation") return glm::vec3(rotation);
  if (kind == "tangent") return {1, 0, 0};
  if (kind == "bitangent") return {0, 1, 0};
  const auto in = [&](const char* name) {
    const std::regex named(std::string("name=\"") + name + "\" type=\"\\w+\" (nodename|value)=\"([^\"]*)\"");
    if (!std::regex_search(inputs, input, named)) throw std::runtime_error(node + " has no " + name);
    return input[1] == "value" ? glm::vec3(std::stof(input[2])) : valueOf(graph, input[2], rotation);
  };
  if (kind == "cos") return glm::cos(in("in"));
  if (kind == "sin") return glm::sin(in("in"));
  if (kind == "add") return in("in1") + in("in2");
  if (kind == "multiply") return in("in1") * in("in2");
  throw std::runtime_error("a node of another kind: " + kind);
}

TEST_F(HandedOver, TheMaterialXTurnsItsAxisAsThePictureSays) {
  const std::string text = read("two_sides.mtlx");
  std::smatch axis;
  ASSERT_TRUE(std::regex_search(
      text, axis, std::regex("geometry_tangent\" type=\"vector3\" nodegraph=\"NG_cloth\" output=\"(\\w+)_out\"")));
  const glm::vec2 slanted = glm::normalize(glm::vec2(2, 1));
  const glm::vec2 shown(valueOf(text, axis[1], rotationOf(slanted)));
  EXPECT_NEAR(std::abs(glm::dot(shown, slanted)), 1, 1e-5) << shown.x << ", " << shown.y;
}

TEST_F(HandedOver, TheFabricOfCloHasMassThicknessAndItsPictureAtTrueSize) {
  const Json json = Json::parse(read("two_sides.jfab"));
  EXPECT_EQ(json["qsFabricNameUTF8"], cloth->fabric.name);
  const Json& physical = json["mapPhysical"];
  EXPECT_NEAR(1e6 * physical["fDensity"].get<double>(), cloth->measures.arealMass_g_m2, 1e-9);
  EXPECT_NEAR(physical["fThickness"].get<double>(), cloth->measures.thickness_mm, 1e-9);
  const Json& texture = json["mapMaterial2D"]["listFaceMaterial"][0]["listTexture"][0];
  EXPECT_EQ(readPngExtent((folder->path() / texture["qsFileName"].get<std::string>()).string()).width,
            cloth->front.maps.tile.width);
  EXPECT_NEAR(texture["v2Size"][0].get<double>(), cloth->width_mm(), 1e-9);
  EXPECT_NEAR(texture["v2Size"][1].get<double>(), cloth->height_mm(), 1e-9);
  int percent = 0;
  const std::string content = json["fabricContent"];
  const std::regex share("([0-9]+)% ");
  for (std::sregex_iterator i(content.begin(), content.end(), share), none; i != none; ++i)
    percent += std::stoi((*i)[1]);
  EXPECT_NEAR(percent, 100, 1) << content;
}

TEST(ClothFacts, WeavesHaveTheNamesOfTheTrade) {
  EXPECT_EQ(constructionOf(plainWeave()).type, "Plain weave");
  EXPECT_EQ(constructionOf(twill(2, 1, Slant::z)).type, "Twill - right hand (Z)");
  EXPECT_EQ(constructionOf(twill(3, 1, Slant::s)).type, "Twill - left hand (S)");
  EXPECT_EQ(constructionOf(satin(5, 2)).type, "Satin");
  EXPECT_EQ(constructionOf(basket(2, 2)).type, "other");
  EXPECT_EQ(constructionOf(waffle(5)).type, "Dobby");
}

TEST(ClothFacts, FibresAreToldByWordsOfTheirNames) {
  Fabric fabric = test::twoSidedCloth();
  const auto named = [&](const char* name) {
    fabric.fibres[0].name = fabric.fibres[1].name = name;
    return compositionOf(fabric, ClothMeasures{}).front().fibre;
  };
  EXPECT_EQ(named("Wool, navy"), (ListedName{"Wool", ""}));
  EXPECT_EQ(named("organic cotton"), (ListedName{"Organic cotton", ""}));
  EXPECT_EQ(named("recycled polyester"), (ListedName{"Recycled Polyester", ""}));
  EXPECT_EQ(named("modacrylic"), (ListedName{"Modacrylic", ""}));
  EXPECT_EQ(named("petrol"), (ListedName{"other", "petrol"}));
  fabric.fibres[1].name = "silk";
  const auto parts = compositionOf(fabric, ClothMeasures{});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].ratio + parts[1].ratio, 1, 1e-12);
  EXPECT_GE(parts[0].ratio, parts[1].ratio);
}

TEST(ClothFacts, EveryFibreOfTheSamplesHasAName) {
  int cloths = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(LOOMLIGHT_SAMPLES)) {
    if (file.path().extension() != ".json") continue;
    const Fabric fabric = readFabric(file.path().string());
    for (const CompositionPart& part : compositionOf(fabric, ClothMeasures{}))
      EXPECT_NE(part.fibre.type, "other") << file;
    ++cloths;
  }
  EXPECT_GE(cloths, 25);
}

}  // namespace
}  // namespace loomlight
