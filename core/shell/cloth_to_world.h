#pragma once

#include <optional>
#include <vector>

#include "core/shell/shell.h"

namespace loomlight {

/// The inverse of Shell::toCloth: where a point of the cloth lies in the world. Prisms are found through a grid over
/// the texture plane. Immutable; safe from any thread.
class ClothToWorld {
 public:
  /// The shell must outlive this.
  explicit ClothToWorld(const Shell& shell);

  struct Point {
    glm::vec3 world;
    int tet;
  };
  /// Cloth coordinates as Shell::toCloth returns them; nullopt where the mesh has no cloth. Of parts of a mesh that
  /// overlap in texture space the first has the point.
  std::optional<Point> operator()(glm::vec3 cloth) const;

 private:
  glm::ivec2 cellOf(glm::vec2 uv) const;

  const Shell& shell_;
  glm::vec2 lower_{0}, perCell_{1};
  glm::ivec2 cells_{1};
  std::vector<uint32_t> firstOfCell_;  ///< into prisms_, one more than cells
  std::vector<uint32_t> prisms_;
  std::vector<glm::mat3> toWorld_;  ///< per tetrahedron
};

}  // namespace loomlight
