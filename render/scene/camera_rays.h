#pragma once

#include <optional>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// How wide what a ray stands for is along it (Amanatides 1984): of a camera's ray, the pixel.
struct RayCone {
  float width_mm = 0;  ///< where the ray begins
  float growth = 0;    ///< mm per mm of the way

  bool isLine() const { return width_mm == 0 && growth == 0; }
  float widthAt(float distance_mm) const { return width_mm + growth * distance_mm; }
};

struct Ray {
  glm::vec3 origin{0};
  glm::vec3 direction{0, 0, 1};  ///< unit
  RayCone cone{};
};

/// Makes the rays of a Camera for pictures of any size. z is up in the picture; looking straight down, it is what lies
/// beyond the target as one came over the azimuth: +y for an azimuth of -90 degrees.
class CameraRays {
 public:
  /// With a divider, of a coarser picture of the same view: each of its pixels stands for divider x divider of a
  /// picture of width x height, from the top left on, so that its last column and row may reach beyond that.
  CameraRays(const Camera& camera, int width, int height, int divider = 1);
  /// x in [0, width / divider), y in [0, height / divider), from the top left; pixel centres at .5. Its cone is a pixel
  /// wide.
  Ray ray(float x, float y) const;
  /// Where the picture shows a point: the inverse of ray(). Nothing for what is not before the camera.
  struct Projection {
    float x, y;         ///< pixels, from the top left
    float distance_mm;  ///< from where the ray to it begins
  };
  std::optional<Projection> project(const glm::vec3& point) const;
  glm::vec3 eye_mm() const { return eye_; }
  /// Size of a pixel, mm, at this distance from the eye.
  float pixelSize_mm(float distance) const;

 private:
  glm::vec3 eye_, forward_, right_, up_;
  glm::vec2 middle_;     ///< of the picture, pixels
  float pixelSize_ = 0;  ///< mm if orthographic, else mm per mm of the way
  bool orthographic_ = false;
};

}  // namespace loomlight
