#include "app/export/handover/textures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/export/handover/side_pixels.h"
#include "core/base/rgb.h"

namespace loomlight {
namespace {

/// Writes pictures of one side, each from a number or a colour of its pixels.
class TextureWriter {
 public:
  TextureWriter(FileSet& set, const DigitalCloth& cloth, const DigitalSide& side, const Task& task)
      : set_(set), density_(cloth.dpiX(), cloth.dpiY()), tile_(side.maps.tile), task_(task) {
    for (size_t i = 0; i < tile_.opacity.size(); ++i) pixels_.push_back(sidePixel(side, i));
  }

  const std::vector<SidePixel>& pixels() const { return pixels_; }

  /// `value`: linear, of a pixel.
  template <class Value>
  void colour(const std::string& file, const Value& value) const {
    if (task_.stopped()) return;
    Pixels8 picture{tile_.width, tile_.height, 3, {}};
    for (const SidePixel& pixel : pixels_) {
      const Rgb shown = srgbFromLinear(value(pixel));
      for (int c = 0; c < 3; ++c) picture.bytes.push_back(byteOf(shown[c]));
    }
    writePng(set_.add(file), picture, {}, density_);
  }

  /// `value`: 0 to 1 in each channel, of a pixel by its number.
  template <class Value>
  void numbers(const std::string& file, const Value& value) const {
    if (task_.stopped()) return;
    Pixels16 picture{tile_.width, tile_.height, 3, {}};
    for (size_t i = 0; i < pixels_.size(); ++i) {
      const glm::vec3 numbers(value(i));
      for (int c = 0; c < 3; ++c)
        picture.values.push_back(static_cast<uint16_t>(std::lround(65535 * std::clamp(numbers[c], 0.0f, 1.0f))));
    }
    writePng(set_.add(file), picture, density_);
  }

 private:
  FileSet& set_;
  PixelDensity density_;
  const TileMaps& tile_;
  const Task& task_;
  std::vector<SidePixel> pixels_;
};

SideTextures::Means meansOf(const std::vector<SidePixel>& pixels) {
  SideTextures::Means means{Rgb(0), 0, 0, 0, 0, 0};
  glm::vec2 axes(0);  // with doubled angles
  for (const SidePixel& pixel : pixels) {
    const DisneyGloss gloss = disneyGloss(pixel.roughness, pixel.anisotropy);
    means.base += pixel.reflected;
    means.opacity += pixel.opacity;
    means.roughness += gloss.roughness;
    means.anisotropy += gloss.anisotropy;
    const glm::vec2 axis = pixel.drawnOut;
    axes += gloss.anisotropy * glm::vec2(axis.x * axis.x - axis.y * axis.y, 2 * axis.x * axis.y);
  }
  const auto count = static_cast<float>(pixels.size());
  means.base /= count;
  means.opacity /= count;
  means.roughness /= count;
  means.anisotropy /= count;
  const float angle = 0.5f * std::atan2(axes.y, axes.x);
  means.anisotropyRotation = rotationOf({std::cos(angle), std::sin(angle)});
  return means;
}

}  // namespace

SideTextures namesOfTextures(const std::string& name, ClothSide side) {
  const std::string stem = "textures/" + name + (side == ClothSide::front ? "_" : "_back_");
  const auto named = [&](const char* suffix) { return stem + suffix + ".png"; };
  SideTextures files;
  files.base = named("BASE");
  files.transmitted = named("TRANS");
  files.normal = named("NRM");
  files.height = named("DISP");
  files.roughness = named("ROUGH");
  files.anisotropy = named("ANISO");
  files.anisotropyRotation = named("ANISOROT");
  files.opacity = named("ALPHA");
  return files;
}

SideTextures writeTextures(FileSet& set, const std::string& name, const DigitalCloth& cloth, ClothSide side,
                           const Task& task) {
  const DigitalSide& of = cloth.of(side);
  const TextureWriter writer(set, cloth, of, task);
  const std::vector<SidePixel>& pixels = writer.pixels();
  const std::vector<float>& height_mm = of.maps.tile.height_mm;
  const auto [low, high] = std::minmax_element(height_mm.begin(), height_mm.end());
  SideTextures files = namesOfTextures(name, side);
  files.lowest_mm = *low;
  files.highest_mm = std::max(*high, *low + 1e-6f);
  const float range_mm = files.highest_mm - files.lowest_mm;
  writer.colour(files.base, [](const SidePixel& pixel) { return pixel.reflected; });
  writer.colour(files.transmitted, [](const SidePixel& pixel) { return pixel.transmitted; });
  writer.numbers(files.normal, [&](size_t i) { return 0.5f * pixels[i].normal + 0.5f; });
  writer.numbers(files.height, [&](size_t i) { return (height_mm[i] - files.lowest_mm) / range_mm; });
  const auto gloss = [&](size_t i) { return disneyGloss(pixels[i].roughness, pixels[i].anisotropy); };
  writer.numbers(files.roughness, [&](size_t i) { return gloss(i).roughness; });
  writer.numbers(files.anisotropy, [&](size_t i) { return gloss(i).anisotropy; });
  writer.numbers(files.anisotropyRotation, [&](size_t i) { return rotationOf(pixels[i].drawnOut); });
  writer.numbers(files.opacity, [&](size_t i) { return pixels[i].opacity; });
  files.means = meansOf(pixels);
  const double sum_mm = std::accumulate(height_mm.begin(), height_mm.end(), 0.0);
  const double mean_mm = sum_mm / static_cast<double>(height_mm.size());
  files.means.height = static_cast<float>((mean_mm - files.lowest_mm) / range_mm);
  return files;
}

}  // namespace loomlight
