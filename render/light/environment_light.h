#pragma once

#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/fabric/fabric.h"
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

  Rgb escape(glm::vec3 d) const;
  bool wantsSampling() const { return true; }
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  float pdf(glm::vec3 d) const { return table_.pdf(toImage(d)); }

 private:
  glm::vec3 toImage(glm::vec3 d) const { return {cos_ * d.x + sin_ * d.y, cos_ * d.y - sin_ * d.x, d.z}; }
  glm::vec3 toWorld(glm::vec3 d) const { return {cos_ * d.x - sin_ * d.y, cos_ * d.y + sin_ * d.x, d.z}; }
  Rgb lookUp(glm::vec3 d) const;

  int width_ = 0, height_ = 0;
  std::vector<Rgb> texels_;
  float intensity_;
  float cos_, sin_;  ///< of the azimuth
  SphereTable table_;
};

}  // namespace loomlight
