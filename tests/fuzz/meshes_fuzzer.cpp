#include <cmath>

#include "core/shell/drape_mesh.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"
#include "tests/fuzz/input_file.h"

namespace loomlight::fuzz {
namespace {

/// The files of all three kinds are told by their names alone, so that one is chosen here by how they begin.
const InputFile& inputFor(std::string_view bytes) {
  static const InputFile ply(".ply"), off(".off"), obj(".obj");
  if (bytes.starts_with("ply")) return ply;
  return bytes.substr(0, 10).find("OFF") != std::string_view::npos ? off : obj;
}

void expectCloth(const DrapeMesh& mesh) {
  const size_t vertices = mesh.positions.size();
  expect(!mesh.triangles.empty(), "a drape without triangles");
  expect(mesh.normals.size() == vertices && mesh.uv_mm.size() == vertices, "a vertex has no normal or no place");
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int c = 0; c < 3; ++c) expect(triangle[c] < vertices, "a triangle has a vertex that there is not");
  for (size_t i = 0; i < vertices; ++i) {
    const float sum =
        mesh.positions[i].x + mesh.positions[i].y + mesh.positions[i].z + mesh.uv_mm[i].x + mesh.uv_mm[i].y;
    expect(std::isfinite(sum), "a vertex is nowhere");
    expect(std::abs(glm::length(mesh.normals[i]) - 1) < 1e-3f, "a normal is no unit vector");
  }
}

}  // namespace

void fuzzMeshes(std::string_view bytes) {
  const std::string& name = inputFor(bytes).holding(bytes);
  isRead(name, [&] { expectCloth(loadDrapeMesh(name, 1)); });
}

}  // namespace loomlight::fuzz
