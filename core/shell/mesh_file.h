#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace loomlight {

/// Triangles as a file has them, polygons cut into fans, nothing judged but that every number is finite and every index
/// exists.
struct MeshFile {
  struct Triangle {
    std::array<uint32_t, 3> vertex;
    std::array<glm::vec2, 3> uv;  ///< in the file's unit
    bool hasUv;
  };
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

inline constexpr size_t kMaxMeshBytes = size_t{512} << 20;
inline constexpr size_t kMaxMeshTriangles = 4'000'000;

/// Reads an OBJ, PLY or OFF file through OpenMesh. Throws InputError for files that are missing, too large, broken, or
/// of another kind. Safe to call from several threads.
MeshFile readMeshFile(const std::string& file);

}  // namespace loomlight
