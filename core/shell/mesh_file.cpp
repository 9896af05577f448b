#include "core/shell/mesh_file.h"

#include <fmt/core.h>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <array>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/shell/mesh_check.h"

// How it works. OpenMesh's readers of OBJ, PLY and OFF hand over what they find, and a SoupImporter takes it as it
// stands: positions, and triangles with a texture coordinate a corner (polygons as fans). No half-edges are built,
// since they would drop faces unsaid; what is wrong with the mesh is found and mended later (mesh_repair). Files are
// checked before the readers see them. Coordinates are in the file's own unit. Cost: linear in the file; one file at
// a time, because the readers share a global object.

namespace loomlight {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec2f;
using OpenMesh::Vec3f;
using OpenMesh::VertexHandle;

/// Receives what OpenMesh's readers find, as it stands in the file: no half-edges are built, so faces that no half-edge
/// mesh could hold reach the repairs instead of being dropped unsaid.
class SoupImporter : public OpenMesh::IO::BaseImporter {
 public:
  SoupImporter(const std::string& file, MeshFile& mesh) : file_(file), mesh_(mesh) {}

  VertexHandle add_vertex() override { return add_vertex(Vec3f(0, 0, 0)); }
  VertexHandle add_vertex(const Vec3f& point) override {
    const VertexHandle vertex(static_cast<int>(mesh_.positions.size()));
    mesh_.positions.emplace_back();
    set_point(vertex, point);
    return vertex;
  }
  void set_point(VertexHandle vertex, const Vec3f& point) override {
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
      throw InputError(fmt::format("{}: vertex {}: expected finite coordinates", file_, vertex.idx()));
    mesh_.positions[static_cast<size_t>(vertex.idx())] = {point[0], point[1], point[2]};
  }
  void set_texcoord(VertexHandle vertex, const Vec2f& uv) override {
    if (!isVertex(vertex)) return;  // the face that names it is refused below
    vertexUv_.resize(mesh_.positions.size(), glm::vec2(0));
    vertexUv_[static_cast<size_t>(vertex.idx())] = {uv[0], uv[1]};
  }
  FaceHandle add_face(const VHandles& vertices) override {
    faceVertices_ = vertices;
    firstTriangle_ = mesh_.triangles.size();
    for (const VertexHandle vertex : vertices)
      if (!isVertex(vertex))
        throw InputError(fmt::format("{}: face {}: names vertex {} (counted from 0), but the file has {}", file_,
                                     faces_, vertex.idx(), mesh_.positions.size()));
    for (size_t i = 2; i < vertices.size(); ++i) addTriangle({0, i - 1, i});
    return FaceHandle(static_cast<int>(faces_++));
  }
  /// Comes after the face, with one entry a corner, and fewer if some corners have none.
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>& uv) override {
    for (size_t i = 2; i < faceVertices_.size(); ++i) {
      MeshFile::Triangle& triangle = mesh_.triangles[firstTriangle_ + i - 2];
      triangle.hasUv = uv.size() == faceVertices_.size();
      if (!triangle.hasUv) continue;
      const std::array<size_t, 3> corners{0, i - 1, i};
      for (size_t k = 0; k < 3; ++k) triangle.uv[k] = finite({uv[corners[k]][0], uv[corners[k]][1]});
    }
  }

  size_t n_vertices() const override { return mesh_.positions.size(); }
  size_t n_faces() const override { return faces_; }
  size_t n_edges() const override { return 0; }

  // What cloth does not ask of a mesh.
  VertexHandle add_vertex(const OpenMesh::Vec3d& point) override { return add_vertex(Vec3f(point)); }
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_normal(VertexHandle, const Vec3f&) override {}
  void set_normal(VertexHandle, const OpenMesh::Vec3d&) override {}
  void set_normal(FaceHandle, const Vec3f&) override {}
  void set_normal(FaceHandle, const OpenMesh::Vec3d&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(VertexHandle, const Vec3f&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec4f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const Vec3f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(FaceHandle, const Vec3f&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec4f&) override {}
  void set_status(VertexHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(HalfedgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(FaceHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  bool isVertex(VertexHandle vertex) const {
    return vertex.idx() >= 0 && static_cast<size_t>(vertex.idx()) < mesh_.positions.size();
  }
  glm::vec2 finite(glm::vec2 uv) const {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
      throw InputError(fmt::format("{}: face {}: expected finite texture coordinates", file_, faces_));
    return uv;
  }
  void addTriangle(std::array<size_t, 3> corners) {
    if (mesh_.triangles.size() >= kMaxMeshTriangles)
      throw InputError(fmt::format("{}: expected at most {} triangles", file_, kMaxMeshTriangles));
    MeshFile::Triangle& triangle = mesh_.triangles.emplace_back();
    triangle.hasUv = true;
    for (size_t k = 0; k < 3; ++k) {
      triangle.vertex[k] = static_cast<uint32_t>(faceVertices_[corners[k]].idx());
      if (triangle.vertex[k] < vertexUv_.size())
        triangle.uv[k] = finite(vertexUv_[triangle.vertex[k]]);
      else
        triangle.hasUv = false;
    }
  }

  const std::string& file_;
  MeshFile& mesh_;
  std::vector<glm::vec2> vertexUv_;
  VHandles faceVertices_;
  size_t firstTriangle_ = 0;
  size_t faces_ = 0;
};

std::string contentOf(const std::string& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (error || !std::filesystem::exists(status))
    throw InputError(fmt::format("{}: no such file; expected a mesh", file));
  if (!std::filesystem::is_regular_file(status)) throw InputError(fmt::format("{}: expected a file", file));
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kMaxMeshBytes)
    throw InputError(fmt::format("{}: expected a mesh of at most {} MB", file, kMaxMeshBytes >> 20));
  std::ifstream stream(file, std::ios::binary);
  std::string content(size, '\0');
  if (!stream.read(content.data(), static_cast<std::streamsize>(size)))
    throw InputError(fmt::format("{}: cannot be read", file));
  return content;
}

/// OpenMesh says nothing to the terminal while this lives: what is wrong with a file is ours to say.
class Silence {
 public:
  Silence() {
    for (size_t i = 0; i < streams_.size(); ++i) {
      enabled_[i] = streams_[i]->is_enabled();
      streams_[i]->disable();
    }
  }
  ~Silence() {
    for (size_t i = 0; i < streams_.size(); ++i)
      if (enabled_[i]) streams_[i]->enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::array<OpenMesh::mostream*, 3> streams_{&omout(), &omlog(), &omerr()};
  std::array<bool, 3> enabled_{};
};

}  // namespace

MeshFile readMeshFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  if (extension != ".obj" && extension != ".ply" && extension != ".off")
    throw InputError(fmt::format("{}: expected a mesh whose name ends in .obj, .ply or .off", file));
  std::string content = contentOf(file);
  if (extension == ".obj") checkObj(file, content);
  if (extension == ".ply") checkPly(file, content);
  if (extension == ".off") checkOff(file, content);

  // OpenMesh's readers, and the streams they complain to, are one for the whole program.
  static std::mutex readers;
  const std::lock_guard lock(readers);
  const Silence silence;
  MeshFile mesh;
  SoupImporter importer(file, mesh);
  OpenMesh::IO::Options options = OpenMesh::IO::Options::VertexTexCoord;
  options += OpenMesh::IO::Options::FaceTexCoord;
  std::istringstream stream(std::move(content));
  // This reader learns what the vertices carry only by being asked about a file, not by reading from a stream.
  if (extension == ".off") OpenMesh::IO::OFFReader().can_u_read(file);
  if (!OpenMesh::IO::IOManager().read(stream, extension.substr(1), importer, options))
    throw InputError(fmt::format("{}: cannot be read as a mesh", file));
  return mesh;
}

}  // namespace loomlight
