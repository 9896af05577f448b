#include "render/media/fibre_exit.h"

#include <algorithm>
#include <cmath>

#include "render/optics/fibre_frame.h"

namespace loomlight {

glm::vec3 fibreExit(const TraceData& cloth, const Collision& collision, glm::vec3 wi, float length_radii) {
  if (length_radii == 0) return collision.place.world;
  const FibreFrame frame(collision.tangent);
  const glm::vec3 out = frame.toLocal(wi), back = frame.toLocal(-collision.incoming);
  const float across = std::hypot(out.y, out.z);
  if (across == 0) return collision.place.world;
  const float sine = collision.offset, cosine = std::sqrt(std::max(0.0f, 1 - sine * sine));
  const glm::vec3 normal(0, (out.y * cosine - out.z * sine) / across, (out.z * cosine + out.y * sine) / across);
  // sin(theta_t) = sin(theta_o) / eta: of every traverse, 2 r cos(gamma_t) tan(theta_t) = chord r sin(theta_t).
  const float index = cloth.materials[static_cast<size_t>(collision.material)].refractiveIndex;
  const float along = -length_radii * collision.radius_mm * back.x / index;
  return collision.axis + along * collision.tangent + collision.radius_mm * frame.toWorld(normal);
}

float traverse_radii(const TraceData& cloth, const Collision& collision) {
  const FibreFrame frame(collision.tangent);
  const Material& material = cloth.materials[static_cast<size_t>(collision.material)];
  return material.bcsdf->modes(frame.toLocal(-collision.incoming), collision.offset).chord_radii;
}

}  // namespace loomlight
