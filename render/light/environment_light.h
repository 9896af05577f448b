#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/fabric/model/fabric.h"
#include "render/light/light_sample.h"
#include "render/light/sphere_table.h"

namespace loomlight {

struct Image;

/// A lat-long image, looked up bilinearly and importance-sampled by its luminance. Its middle lies in the direction of
/// the light's azimuth; azimuth falls to the right, as seen from inside; the top row is the zenith.
///
/// Cleaned when loaded: NaN and negative values become 0, infinite ones the largest finite one. Images wider than 4096
/// pixels are averaged down by powers of two, which bounds the memory: at most 17 bytes for each of 4096 x 2048 pixels.
class EnvironmentLight {
 public:
  static constexpr int maxWidth = 4096;

  /// Reads light.file. Throws InputError when it is no EXR, has neither R, G, B nor Y, or is not twice as wide as high.
  explicit EnvironmentLight(const Light& light);
  /// `file` only names the image in messages.
  EnvironmentLight(Image image, const Light& light, const std::string& file);
  /// The image of another light, not read again, as this one shines.
  EnvironmentLight(const EnvironmentLight& other, const Light& light) : EnvironmentLight(other.map_, light) {}

  Rgb escape(glm::vec3 d) const;
  bool wantsSampling() const { return true; }
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  float pdf(glm::vec3 d) const { return map_->table.pdf(toImage(d)); }

 private:
  struct Map {
    Map(Image image, const std::string& file);
    int width = 0, height = 0;
    std::vector<Rgb> texels;
    SphereTable table;
  };
  EnvironmentLight(std::shared_ptr<const Map> map, const Light& light);
  glm::vec3 toImage(glm::vec3 d) const { return {cos_ * d.x + sin_ * d.y, cos_ * d.y - sin_ * d.x, d.z}; }
  glm::vec3 toWorld(glm::vec3 d) const { return {cos_ * d.x - sin_ * d.y, cos_ * d.y + sin_ * d.x, d.z}; }
  Rgb lookUp(glm::vec3 d) const;

  std::shared_ptr<const Map> map_;
  float intensity_;
  float cos_, sin_;  ///< of the azimuth
};

}  // namespace loomlight
