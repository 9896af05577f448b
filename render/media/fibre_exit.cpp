#include "render/media/fibre_exit.h"

#include <algorithm>
#include <cmath>

#include "render/optics/fibre_frame.h"

namespace loomlight {

glm::vec3 fibreExit(const TraceData& cloth, const Collision& collision, glm::vec3 wi, int order) {
  if (order == 0) return collision.place.world;
  const FibreFrame frame(collision.tangent);
  const glm::vec3 out = frame.toLocal(wi), back = frame.toLocal(-collision.incoming);
  const float across = std::hypot(out.y, out.z);
  if (across == 0) return collision.place.world;
  const float sine = collision.offset, cosine = std::sqrt(std::max(0.0f, 1 - sine * sine));
  const glm::vec3 normal(0, (out.y * cosine - out.z * sine) / across, (out.z * cosine + out.y * sine) / across);
  // sin(theta_t) = sin(theta_o) / eta: of every traverse, 2 r cos(gamma_t) tan(theta_t) = chord r sin(theta_t).
  const Material& material = cloth.materials[collision.material];
  const float chord = material.bcsdf->modes(back, sine).chord;
  const float along = -static_cast<float>(order) * chord * collision.radius_mm * back.x / material.refractiveIndex;
  return collision.axis + along * collision.tangent + collision.radius_mm * frame.toWorld(normal);
}

}  // namespace loomlight
