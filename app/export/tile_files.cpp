#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/export/file_set.h"
#include "app/export/tile.h"
#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/base/units.h"
#include "core/fabric/json/json_text.h"

namespace loomlight {
namespace {

/// A picture of the maps: three bytes a pixel from its index.
template <class Colour>
Pixels8 picture(const TileMaps& maps, const Colour& colour) {
  Pixels8 pixels{maps.width, maps.height, 3, {}};
  pixels.bytes.reserve(3 * maps.opacity.size());
  for (size_t i = 0; i < maps.opacity.size(); ++i) {
    const Rgb c = colour(i);
    for (int channel = 0; channel < 3; ++channel) pixels.bytes.push_back(byteOf(c[channel]));
  }
  return pixels;
}

/// Numbers of the maps from 0 to 1, 65535 steps to each.
template <class Value>
Pixels16 numbers(const TileMaps& maps, int channels, const Value& value) {
  Pixels16 pixels{maps.width, maps.height, channels, {}};
  for (size_t i = 0; i < maps.opacity.size(); ++i)
    for (int channel = 0; channel < channels; ++channel)
      pixels.values.push_back(static_cast<uint16_t>(std::lround(65535 * std::clamp(value(i, channel), 0.0f, 1.0f))));
  return pixels;
}

/// Colours that tell yarns apart at a glance: hues a golden angle apart. Black is no yarn.
Rgb idColour(int yarn) {
  if (yarn < 0) return Rgb(0);
  const float hue = std::fmod(0.61803399f * static_cast<float>(yarn), 1.0f) * 6;
  const auto ramp = [hue](float shift) {
    return std::clamp(std::abs(std::fmod(hue + shift, 6.0f) - 3) - 1, 0.0f, 1.0f);
  };
  return Rgb(0.25f) + 0.75f * Rgb(ramp(0), ramp(4), ramp(2));
}

Image imageOf(const TileMaps& maps) {
  Image image;
  image.width = maps.width;
  image.height = maps.height;
  const auto channel = [&](const char* name, const auto& value) {
    std::vector<float>& values = image.add(name);
    for (size_t i = 0; i < values.size(); ++i) values[i] = value(i);
  };
  const char* const kColours[] = {"R", "G", "B"};
  const char* const kNormals[] = {"normal.X", "normal.Y", "normal.Z"};
  for (int c = 0; c < 3; ++c) channel(kColours[c], [&](size_t i) { return maps.baseColour[i][c]; });
  channel("opacity.Y", [&](size_t i) { return maps.opacity[i]; });
  for (int c = 0; c < 3; ++c) channel(kNormals[c], [&](size_t i) { return maps.normal[i][c]; });
  channel("height.Z", [&](size_t i) { return maps.height_mm[i]; });
  channel("yarn.id", [&](size_t i) { return static_cast<float>(maps.yarn[i]); });
  return image;
}

std::string hex(const Rgb& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", byteOf(colour.x), byteOf(colour.y), byteOf(colour.z));
}

}  // namespace

TileReport writeTile(const std::string& stem, const TileMaps& maps, const Fabric& fabric, const TileExtent& extent,
                     const ClothMeasures& measures, const std::vector<std::string>& names) {
  const std::filesystem::path path(stem);
  const auto fileName = [&](const char* ending) { return path.filename().string() + ending; };
  TileReport report;
  FileSet set(path.parent_path().string(), path.filename().string());
  const auto named = [&](const char* ending) {
    report.files.push_back(stem + ending);
    return set.add(fileName(ending));
  };
  const auto [low, high] = std::minmax_element(maps.height_mm.begin(), maps.height_mm.end());
  const float lowest = *low, range = std::max(1e-6f, *high - *low);
  const double dpi = kMmPerInch * maps.width / (extent.ends * fabric.warpPitch_mm());
  const auto write = [&](const char* ending, const Pixels8& pixels) { writePng(named(ending), pixels, {}, dpi); };
  writeExr(named(".exr"), imageOf(maps), dpi);
  write("_basecolor.png", picture(maps, [&](size_t i) { return srgbFromLinear(maps.baseColour[i]); }));
  writePng(named("_normal.png"), numbers(maps, 3, [&](size_t i, int c) { return 0.5f * maps.normal[i][c] + 0.5f; }),
           dpi);
  writePng(named("_height.png"), numbers(maps, 1, [&](size_t i, int) { return (maps.height_mm[i] - lowest) / range; }),
           dpi);
  write("_opacity.png", picture(maps, [&](size_t i) { return Rgb(maps.opacity[i]); }));
  write("_yarn.png", picture(maps, [&](size_t i) { return idColour(maps.yarn[i]); }));

  nlohmann::ordered_json yarns = nlohmann::ordered_json::array();
  for (size_t i = 0; i < names.size(); ++i)
    yarns.push_back({{"id", i}, {"name", names[i]}, {"color", hex(idColour(static_cast<int>(i)))}});
  const nlohmann::ordered_json json = {
      {"name", fabric.name},
      {"program", "Loomlight " LOOMLIGHT_VERSION},
      {"width_mm", extent.ends * fabric.warpPitch_mm()},
      {"height_mm", extent.picks * fabric.weftPitch_mm()},
      {"ends", extent.ends},
      {"picks", extent.picks},
      {"twist_joins", extent.twistJoins},
      {"width_px", maps.width},
      {"height_px", maps.height},
      {"areal_mass_g_m2", measures.arealMass_g_m2},
      {"thickness_mm", measures.thickness_mm},
      {"maps",
       {{"all",
         {{"file", fileName(".exr")},
          {"encoding", "linear"},
          {"layers",
           {{"RGB", "base color, not multiplied by opacity"},
            {"normal.XYZ", "-1 to 1, y up (OpenGL)"},
            {"height.Z", "mm above the mid-plane"},
            {"opacity.Y", "0 to 1"},
            {"yarn.id", "number of the yarn, -1 in holes"}}}}},
        {"base_color", {{"file", fileName("_basecolor.png")}, {"encoding", "sRGB, not multiplied by opacity"}}},
        {"normal", {{"file", fileName("_normal.png")}, {"encoding", "linear, 16 bits, y up (OpenGL)"}}},
        {"height",
         {{"file", fileName("_height.png")},
          {"encoding", "linear, 16 bits"},
          {"black_mm", lowest},
          {"white_mm", lowest + range}}},
        {"opacity", {{"file", fileName("_opacity.png")}, {"encoding", "linear"}}},
        {"yarn", {{"file", fileName("_yarn.png")}, {"encoding", "a color a yarn"}, {"yarns", yarns}}}}}};
  report.json = jsonText(json, 2) + "\n";
  writeFileAtomically(named(".json"), report.json);
  set.place();
  return report;
}

}  // namespace loomlight
