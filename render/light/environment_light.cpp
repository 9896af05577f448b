#include "render/light/environment_light.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "render/film/image.h"
#include "render/film/pixel_rect.h"
#include "render/light/lat_long.h"

// How it works. The picture is made finite and small enough, and a table of the mean luminance around every texel is
// sampled by inversion (sphere_table.h). Light is looked up bilinearly, so the means are over what that interpolation
// shows: wherever there is light, the table's density is not 0.

namespace loomlight {
namespace {

/// Brighter than any picture of the sun in cd/m2; keeps sums and products of radiances finite.
constexpr float kMaxRadiance = 1e10f;

void clean(std::vector<float>& values) {
  float largest = 0;
  for (const float v : values)
    if (std::isfinite(v)) largest = std::max(largest, v);
  for (float& v : values) {
    if (std::isinf(v)) v = v > 0 ? largest : 0.0f;
    v = v > 0 ? std::min(v, kMaxRadiance) : 0.0f;
  }
}

/// Means of two by two pixels; at an odd edge, of the last one twice.
std::vector<float> halve(const std::vector<float>& from, int width, int height) {
  const int w = (width + 1) / 2, h = (height + 1) / 2;
  std::vector<float> to(pixelCount(w, h));
  const auto value = [&](int x, int y) {
    return from[pixelIndex(std::min(x, width - 1), std::min(y, height - 1), width)];
  };
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const float sum =
          value(2 * x, 2 * y) + value(2 * x + 1, 2 * y) + value(2 * x, 2 * y + 1) + value(2 * x + 1, 2 * y + 1);
      to[pixelIndex(x, y, w)] = 0.25f * sum;
    }
  }
  return to;
}

/// Clean, of bounded size, with the channels R, G, B.
Image prepare(Image image, const std::string& file) {
  if (std::abs(image.width - 2 * image.height) > 2 + image.height / 32)
    throw InputError(fmt::format("{}: {} x {} pixels: expected a latitude-longitude image, twice as wide as high", file,
                                 image.width, image.height));
  const bool grey = !image.find("R") && image.find("Y");
  Image out;
  for (const char* name : {"R", "G", "B"}) {
    const std::string source = grey ? "Y" : name;
    const Image::Channel* channel = image.find(source);
    if (!channel) throw InputError(fmt::format("{}: no channel {}: expected R, G and B, or Y", file, source));
    std::vector<float> values = channel->values;
    clean(values);
    out.width = image.width;
    out.height = image.height;
    while (out.width > EnvironmentLight::maxWidth) {
      values = halve(values, out.width, out.height);
      out.width = (out.width + 1) / 2;
      out.height = (out.height + 1) / 2;
    }
    out.channels.push_back({name, std::move(values)});
  }
  return out;
}

std::vector<Rgb> interleave(const Image& image) {
  std::vector<Rgb> texels(image.channels[0].values.size());
  for (size_t i = 0; i < texels.size(); ++i)
    texels[i] = {image.channels[0].values[i], image.channels[1].values[i], image.channels[2].values[i]};
  return texels;
}

/// Mean luminance over each cell of the bilinear interpolation between texels: 1/8, 3/4, 1/8 along both axes. So the
/// table is never 0 where the light is not.
std::vector<float> cellMeans(const std::vector<Rgb>& texels, int width, int height) {
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  std::vector<float> rows(w * h), means(w * h);
  for (size_t y = 0; y < h; ++y) {
    const Rgb* t = &texels[y * w];
    for (size_t x = 0; x < w; ++x)
      rows[y * w + x] = 0.75f * luminance(t[x]) + 0.125f * (luminance(t[(x + w - 1) % w]) + luminance(t[(x + 1) % w]));
  }
  for (size_t y = 0; y < h; ++y) {
    const size_t above = y == 0 ? 0 : y - 1, below = std::min(y + 1, h - 1);
    for (size_t x = 0; x < w; ++x)
      means[y * w + x] = 0.75f * rows[y * w + x] + 0.125f * (rows[above * w + x] + rows[below * w + x]);
  }
  return means;
}

Image read(const Light& light) {
  if (light.file.empty()) throw InputError("light: no file given, expected a latitude-longitude EXR");
  return readExr(light.file);
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Light& light) : EnvironmentLight(read(light), light, light.file) {}

EnvironmentLight::EnvironmentLight(Image image, const Light& light, const std::string& file)
    : EnvironmentLight(std::make_shared<const Map>(std::move(image), file), light) {}

EnvironmentLight::EnvironmentLight(std::shared_ptr<const Map> map, const Light& light)
    : map_(std::move(map)),
      intensity_(static_cast<float>(light.intensity)),
      cos_(static_cast<float>(std::cos(light.azimuth_deg * kPi / 180))),
      sin_(static_cast<float>(std::sin(light.azimuth_deg * kPi / 180))) {}

EnvironmentLight::Map::Map(Image image, const std::string& file)
    : table([&] {
        const Image prepared = prepare(std::move(image), file);
        width = prepared.width;
        height = prepared.height;
        texels = interleave(prepared);
        return SphereTable(width, height, cellMeans(texels, width, height));
      }()) {}

Rgb EnvironmentLight::lookUp(glm::vec3 d) const {
  const int width = map_->width, height = map_->height;
  const float x = latLongU(d) * static_cast<float>(width) - 0.5f, y = latLongV(d) * static_cast<float>(height) - 0.5f;
  const float floorX = std::floor(x), floorY = std::floor(y);
  const int left = (static_cast<int>(floorX) + width) % width, right = (left + 1) % width;
  const int top = std::clamp(static_cast<int>(floorY), 0, height - 1);
  const int bottom = std::clamp(static_cast<int>(floorY) + 1, 0, height - 1);
  const auto texel = [&](int column, int row) { return map_->texels[pixelIndex(column, row, width)]; };
  const float fx = x - floorX, fy = y - floorY;
  return glm::mix(glm::mix(texel(left, top), texel(right, top), fx),
                  glm::mix(texel(left, bottom), texel(right, bottom), fx), fy);
}

Rgb EnvironmentLight::escape(glm::vec3 d) const {
  return intensity_ * lookUp(toImage(d));
}

std::optional<LightSample> EnvironmentLight::sample(glm::vec3, Random& random) const {
  if (!(intensity_ > 0 && map_->table.power() > 0)) return std::nullopt;
  const SphereTable::Sample chosen = map_->table.sample(random);
  return LightSample{toWorld(chosen.direction), std::numeric_limits<float>::infinity(), chosen.pdf};
}

}  // namespace loomlight
