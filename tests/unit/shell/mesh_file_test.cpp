#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/shell/drape_surface.h"
#include "core/shell/shell.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MeshFiles : public testing::Test {
 protected:
  DrapeMesh load(const std::string& name, const std::string& content, double scale = 1) {
    const std::string file = folder_.file(name);
    test::putBytes(file, content);
    return loadDrapeMesh(file, scale);
  }
  std::string failure(const std::string& name, const std::string& content, double scale = 1) {
    try {
      load(name, content, scale);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  test::ScratchFolder folder_;
};

const char* const kQuad =
    "mtllib none.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl cloth\nf 1/1 2/2 3/3 4/4\n";

std::string plyHeader(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class T>
void append(std::string& bytes, T value, bool bigEndian) {
  std::string raw(reinterpret_cast<const char*>(&value), sizeof(T));
  if (bigEndian) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

std::string binaryPly(bool bigEndian, float lastCoordinate = 0) {
  std::string bytes = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian", 3, 1);
  for (const float value : {0.f, 0.f, 0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, lastCoordinate, 0.f, 2.f})
    append(bytes, value, bigEndian);
  append(bytes, uint8_t{3}, bigEndian);
  for (const int32_t index : {0, 1, 2}) append(bytes, index, bigEndian);
  return bytes;
}

TEST_F(MeshFiles, ReadsAQuad) {
  const DrapeMesh mesh = load("a.obj", kQuad, 2);
  EXPECT_THAT(mesh.repairs, IsEmpty());
  EXPECT_EQ(mesh.triangles.size(), 2u);
  ASSERT_EQ(mesh.positions.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.positions[i] + glm::vec3(1, 1, 0), glm::vec3(mesh.uv_mm[i], 0));  // centred; uv scaled by 2
    EXPECT_EQ(mesh.normals[i], glm::vec3(0, 0, 1));
  }
}

TEST_F(MeshFiles, ReadsEveryFormatAlike) {
  const std::string off = "STOFF # with texture\n3 1 0\n0 0 0 0 0\n2 0 0 2 0\n0 2 0 0 2\n# the face\n3 0 1 2\n";
  const std::string offNormals = "STNOFF\n3 1 0\n0 0 0 0 0 1 0 0\n2 0 0 0 0 1 2 0\n0 2 0 0 0 1 0 2\n3 0 1 2\n";
  const std::string ply = plyHeader("ascii", 3, 1) + "0 0 0 0 0\n2 0 0 2 0\n0 2 0 0 2\n3 0 1 2\n";
  const std::string obj = "v 0 0 0\r\nv 2 0 0\r\nv 0 2 0\r\nvt 0 0\r\nvt 2 0\r\nvt 0 2\r\nf -3/-3/9 -2/-2 -1/-1\r\n";
  const std::map<std::string, std::string> files{{"a.off", off.substr(0, 5) + off.substr(20)},
                                                 {"n.OFF", offNormals},
                                                 {"a.ply", ply},
                                                 {"l.ply", binaryPly(false)},
                                                 {"b.ply", binaryPly(true)},
                                                 {"a.obj", obj}};
  for (const auto& [name, content] : files) {
    const DrapeMesh mesh = load(name, content);
    EXPECT_THAT(mesh.repairs, IsEmpty()) << name;
    ASSERT_EQ(mesh.triangles.size(), 1u) << name;
    for (size_t i = 0; i < 3; ++i)
      EXPECT_EQ(mesh.positions[i] + glm::vec3(1, 1, 0), glm::vec3(mesh.uv_mm[i], 0)) << name;
  }
}

TEST_F(MeshFiles, SeamsSplitVerticesButNotTheShell) {
  // Two triangles side by side; their texture lies in two places.
  const DrapeMesh mesh = load("a.obj",
                              "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 2 0\nvt 2 2\nvt 10 0\nvt 12 2\nvt 10 2\n"
                              "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n");
  EXPECT_EQ(mesh.positions.size(), 6u);
  const Shell shell(DrapeSurface(mesh), 0.1);
  size_t inner = 0;
  for (const Shell::Tet& tet : shell.tets())
    for (const int32_t neighbour : tet.neighbour) inner += neighbour >= 0;
  EXPECT_EQ(inner, 2u * (2 + 2 + 2));  // two inside each prism, two across the seam
  EXPECT_EQ(shell.uvUpper_mm(), glm::vec2(12, 2));
}

TEST_F(MeshFiles, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_THAT(failure("a.obj", "v 0 0 0\nv 1 0 nan\n"),
              AllOf(HasSubstr("a.obj:2:"), HasSubstr("expected 3 numbers"), HasSubstr("'nan'")));
  EXPECT_THAT(failure("a.obj", "v 0 0\n"), HasSubstr("a.obj:1: expected 3 numbers"));
  EXPECT_THAT(failure("a.obj", "v 1e39 0 0\n"), HasSubstr("1e39"));
  EXPECT_THAT(failure("a.obj", "v 0 \xFF\xC3\x07 0\n"), HasSubstr("got '" + std::string(3, '?')));
  EXPECT_THAT(failure("a.obj", "v 0 0 0\nvt 0\n"), HasSubstr("a.obj:2: expected 2 numbers"));
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
  EXPECT_THAT(failure("a.obj", three + "f 1/1 2/2 9/3\n"),
              AllOf(HasSubstr("a.obj:7:"), HasSubstr("vertex 9"), HasSubstr("has 3")));
  EXPECT_THAT(failure("a.obj", three + "f 1/1 2/2 -4/3\n"), HasSubstr("vertex -4"));
  EXPECT_THAT(failure("a.obj", three + "f 1/1 2/2 0/3\n"), HasSubstr("vertex 0"));
  EXPECT_THAT(failure("a.obj", three + "f 1/1 2/2 3/7\n"), HasSubstr("texture coordinate 7"));
  EXPECT_THAT(failure("a.obj", three + "f 1/1 2/2 99999999999999999999/3\n"), HasSubstr("number of a vertex"));
  EXPECT_THAT(failure("a.obj", three + "f /1 2/2 3/3\n"), HasSubstr("number of a vertex"));
  EXPECT_THAT(failure("a.obj", three + "f 1/1 2/2\n"), HasSubstr("at least 3 corners"));
  EXPECT_THAT(failure("a.ply", plyHeader("ascii", 3, 1) + "0 0 0 0 0\n1 0 0 1 0\n"),
              HasSubstr("a.ply:14: the file ends early"));
  EXPECT_THAT(failure("a.ply", plyHeader("ascii", 1, 0) + "0 0 x 0 0\n"),
              HasSubstr("expected a number for 'z', got 'x'"));
  EXPECT_THAT(failure("a.off", "STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1\n"),
              HasSubstr("a.off:4: expected 5 numbers for vertex 1"));
  EXPECT_THAT(failure("a.off", "STOFF\n1 1 0\n0 0 0 0 0\n3 0 0 1\n"), HasSubstr("names vertex 1, but the file has 1"));
}

TEST_F(MeshFiles, RefusesWhatIsNoMesh) {
  EXPECT_THAT(failure("a.obj", ""), AllOf(HasSubstr("a.obj"), HasSubstr("expected a mesh with triangles")));
  EXPECT_THAT(failure("a.obj", "v 0 0 0\n"), HasSubstr("expected a mesh with triangles"));
  EXPECT_THAT(failure("a.ply", ""), HasSubstr("begins with 'ply'"));
  EXPECT_THAT(failure("a.off", ""), HasSubstr("STOFF"));
  EXPECT_THAT(failure("a.stl", "solid\n"), HasSubstr(".obj, .ply or .off"));
  EXPECT_THROW(loadDrapeMesh(folder_.file("none.obj"), 1), InputError);
  std::filesystem::create_directory(folder_.path() / "folder.obj");
  EXPECT_THROW(loadDrapeMesh(folder_.file("folder.obj"), 1), InputError);
  EXPECT_THAT(failure("a.obj", kQuad, 0), HasSubstr("a.obj: drape.uv_scale_mm: expected"));
  EXPECT_THAT(failure("a.obj", kQuad, 1e6), HasSubstr("expected cloth of at most"));
  EXPECT_THAT(failure("a.obj", "v 0 0 0\nv 1e6 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"),
              HasSubstr("mesh of at most"));
  std::ofstream huge(folder_.file("huge.obj"));
  huge.close();
  std::filesystem::resize_file(folder_.file("huge.obj"), size_t{513} << 20);  // sparse
  EXPECT_THROW(loadDrapeMesh(folder_.file("huge.obj"), 1), InputError);
}

TEST_F(MeshFiles, RefusesCountsThatWouldTakeAllMemory) {
  EXPECT_THAT(failure("a.ply", plyHeader("ascii", 2000000000, 1)), HasSubstr("number of elements"));
  EXPECT_THAT(failure("a.ply", plyHeader("binary_little_endian", 3000000, 1)), HasSubstr("ends early"));
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty "
      "float z\nproperty float u\nproperty float v\nelement face 1\nproperty list uint int vertex_indices\n"
      "end_header\n";
  append(bytes, uint32_t{4000000000u}, false);
  EXPECT_THAT(failure("a.ply", bytes), HasSubstr("expected 3 to 1000 corners, got 4000000000"));
  EXPECT_THAT(failure("a.off", "STOFF\n4000000000 1 0\n"), HasSubstr("numbers of vertices and faces"));
  EXPECT_THAT(failure("a.off", "STOFF BINARY\n"), HasSubstr("ASCII"));
}

TEST_F(MeshFiles, RefusesNumbersThatAreNoneInBinaryFiles) {
  EXPECT_THAT(failure("a.ply", binaryPly(false, std::numeric_limits<float>::quiet_NaN())),
              HasSubstr("vertex 2: expected finite"));
  std::string bytes = binaryPly(false);
  bytes[bytes.size() - 4] = 77;  // the last index
  EXPECT_THAT(failure("a.ply", bytes), AllOf(HasSubstr("names vertex 77"), HasSubstr("the file has 3")));
}

TEST_F(MeshFiles, AreNamedWhereTheirClothIsTooThick) {
  DrapeMesh mesh = load("a.obj", kQuad, 2);
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  const DrapeSurface creased(mesh);
  EXPECT_THAT(test::messageOf<InputError>([&] { Shell(creased, 0.1); }),
              HasSubstr("a.obj: expected triangles that can carry cloth 0.2 mm thick; all 2 are creased"));
}

TEST_F(MeshFiles, AsksForTextureCoordinates) {
  EXPECT_THAT(failure("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("no texture coordinates; expected"));
  EXPECT_THAT(failure("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), HasSubstr("STOFF"));
  std::string header = plyHeader("ascii", 0, 0);
  header.replace(header.find("float s"), 7, "float a");
  EXPECT_THAT(failure("a.ply", header), HasSubstr("no texture coordinates"));
  const DrapeMesh mesh = load("a.obj", std::string(kQuad) + "f 1 2 3\nf 1/1 2 3/3\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_THAT(mesh.repairs, testing::Contains(HasSubstr("2 of 4 triangles have no texture coordinates")));
}

TEST_F(MeshFiles, LeavesOutTrianglesWithoutArea) {
  const DrapeMesh mesh = load("a.obj", std::string(kQuad) + "v 4 0 0\nvt 2 0\nf 1/1 2/2 5/3\nf 1/1 2/2 3/2\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_THAT(mesh.repairs, testing::Contains(HasSubstr("1 of 4 triangles have no area and")));
  EXPECT_THAT(mesh.repairs, testing::Contains(HasSubstr("1 of 4 triangles have no area in texture space")));
  EXPECT_THAT(failure("a.obj", "v 0 0 0\nv 0 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"),
              HasSubstr("none in the world"));
}

TEST_F(MeshFiles, TurnsMirroredTextureAndWindingRound) {
  const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 2 0\nvt 0 0\nvt 0 2\nvt 2 2\n";
  for (const char* faces : {"f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", "f 1/1 2/2 3/3\nf 1/1 4/4 3/3\n"}) {
    const DrapeMesh mesh = load("a.obj", corners + faces);
    EXPECT_THAT(mesh.repairs, testing::Contains(HasSubstr("mirrored")));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    const glm::vec3 up = mesh.normals[0];
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec2 u1 = mesh.uv_mm[t[1]] - mesh.uv_mm[t[0]], u2 = mesh.uv_mm[t[2]] - mesh.uv_mm[t[0]];
      EXPECT_GT(u1.x * u2.y - u1.y * u2.x, 0);
      EXPECT_GT(
          glm::dot(glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]),
                   up),
          0);
    }
    EXPECT_THAT(Shell(DrapeSurface(mesh), 0.1).tets(), testing::SizeIs(6));
  }
}

TEST_F(MeshFiles, EndsTheClothAtCrowdedEdges) {
  // Three leaves of a book.
  const DrapeMesh mesh = load("a.obj",
                              "v 0 0 0\nv 0 2 0\nv 2 1 0\nv -2 1 0\nv 0 1 2\nvt 0 0\nvt 0 2\nvt 2 1\nvt -2 1\nvt 1 1\n"
                              "f 2/2 1/1 3/3\nf 1/1 2/2 4/4\nf 2/2 1/1 5/5\n");
  EXPECT_THAT(mesh.repairs, testing::Contains(HasSubstr("1 edges are shared by more than two triangles")));
  const Shell shell(DrapeSurface(mesh), 0.05);
  for (const Shell::Tet& tet : shell.tets()) EXPECT_GT(glm::determinant(tet.toCloth), 0);
}

TEST_F(MeshFiles, NotesATextureScaleThatStretchesTheCloth) {
  const DrapeMesh mesh = load("a.obj", kQuad, 1);  // 2 mm of mesh per mm of cloth
  EXPECT_THAT(mesh.repairs, ElementsAre(HasSubstr("drape.uv_scale_mm 2 would make them equal")));
}

/// Whatever bytes a file has, loading it ends, with a mesh that makes a shell or with a message.
TEST_F(MeshFiles, SurvivesDamagedFiles) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.obj", kQuad},
      {"a.off", "STOFF\n4 2 0\n0 0 0 0 0\n2 0 0 2 0\n2 2 0 2 2\n0 2 0 0 2\n3 0 1 2\n3 0 2 3\n"},
      {"a.ply", plyHeader("ascii", 3, 1) + "0 0 0 0 0\n2 0 0 2 0\n0 2 0 0 2\n3 0 1 2\n"},
      {"b.ply", binaryPly(false)}};
  Random random(11);
  int accepted = 0;
  testing::internal::CaptureStderr();
  for (int round = 0; round < 150; ++round) {
    for (const auto& [name, whole] : files) {
      std::string content = whole;
      const uint32_t damages = 1 + random.below(3);
      for (uint32_t i = 0; i < damages; ++i) {
        const uint32_t at = random.below(static_cast<uint32_t>(content.size()));
        const uint32_t kind = random.below(4);
        if (kind == 0) content.resize(at + 1);
        if (kind == 1) content[at] = static_cast<char>(random.below(256));
        if (kind == 2) content[at] = "0123456789-./ \n"[random.below(15)];
        if (kind == 3) content.insert(at, content.substr(random.below(static_cast<uint32_t>(content.size())), 12));
      }
      try {
        const Shell shell(DrapeSurface(load(name, content)), 0.1);
        ++accepted;
        for (const Shell::Tet& tet : shell.tets()) EXPECT_GT(glm::determinant(tet.toCloth), 0);
      } catch (const InputError& error) {
        const std::string said = error.what();
        EXPECT_LT(said.size(), 600u);
        for (const char c : said) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) << said;
      }
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "what is wrong with a file is said in the message alone";
  EXPECT_GT(accepted, 10) << "the damage should leave some files whole enough";
}

}  // namespace
}  // namespace loomlight
