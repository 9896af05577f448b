#pragma once

#include <memory>
#include <optional>

#include "core/shell/shell.h"

struct RTCSceneTy;  // Embree's, which only the source file needs

namespace loomlight {

class EmbreeDevice;

/// Finds where a ray enters the cloth from outside. One Embree scene of the shell's boundary, or a box if it is flat;
/// immutable, and safe to ask from many threads.
class ShellEntry {
 public:
  explicit ShellEntry(std::shared_ptr<const Shell> shell);
  ~ShellEntry();
  ShellEntry(ShellEntry&&) = delete;
  ShellEntry& operator=(ShellEntry&&) = delete;

  struct Hit {
    float t;  ///< >= tMin
    int tet;  ///< 0 if the shell is flat
  };
  /// The first tetrahedron that a ray comes into through the boundary, at a parameter in [tMin, tMax]; `direction` is
  /// unit, tMin >= 0. Shell::exit of that tetrahedron, asked with the same origin and direction, is greater than t by
  /// more than rounding. So a ray goes on by asking again from where it left, and always gets farther; a part that
  /// touches the one it has left is not missed though rounding puts its entry a little before the exit. A ray that
  /// starts deep inside does not enter what it is in.
  std::optional<Hit> enter(glm::vec3 origin, glm::vec3 direction, float tMin, float tMax) const;

 private:
  struct ReleaseScene {
    void operator()(RTCSceneTy* scene) const;
  };

  std::optional<Hit> enterBox(glm::vec3 origin, glm::vec3 direction, float tMin, float tMax) const;

  std::shared_ptr<const Shell> shell_;
  std::unique_ptr<const EmbreeDevice> device_;
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
  float reach_ = 0;  ///< largest coordinate, mm: how exact parameters can be
};

}  // namespace loomlight
