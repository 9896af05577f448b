#include <fmt/core.h>

#include "core/shell/mesh_check.h"
#include "core/shell/mesh_text.h"

namespace loomlight {
namespace {

struct Counts {
  int64_t vertices = 0, texcoords = 0;
};

Counts countAll(const std::string& file, const std::string& content) {
  Counts counts;
  MeshText text(file, content);
  while (text.nextLine()) {
    const std::string_view key = text.word();
    counts.vertices += key == "v";
    counts.texcoords += key == "vt";
  }
  return counts;
}

void checkNumbers(MeshText& text, int count, std::string_view what) {
  for (int i = 0; i < count; ++i) {
    const std::string_view word = text.word();
    if (!parseCoordinate(word))
      text.fail(fmt::format("expected {} numbers for {}, got '{}'", count, what, word.substr(0, 40)));
  }
}

/// One index of a corner; OBJ counts from 1, and from the last one so far backwards with negative numbers.
void checkIndex(const MeshText& text, std::string_view word, std::string_view what, int64_t soFar, int64_t total) {
  const std::optional<int64_t> index = parseInteger(word);
  if (!index) text.fail(fmt::format("expected the number of a {}, got '{}'", what, word.substr(0, 40)));
  if (*index == 0 || *index > total || *index < -soFar)
    text.fail(fmt::format("face names {} {}, but the file has {}; expected 1 to {}", what, *index, total, total));
}

void checkFace(MeshText& text, const Counts& soFar, const Counts& total) {
  int corners = 0;
  for (std::string_view corner = text.word(); !corner.empty(); corner = text.word()) {
    if (++corners > kMaxCorners) text.fail(fmt::format("expected a face of at most {} corners", kMaxCorners));
    const size_t slash = std::min(corner.find('/'), corner.size());
    checkIndex(text, corner.substr(0, slash), "vertex", soFar.vertices, total.vertices);
    if (slash == corner.size()) continue;
    corner.remove_prefix(slash + 1);
    const size_t second = std::min(corner.find('/'), corner.size());
    if (second > 0) checkIndex(text, corner.substr(0, second), "texture coordinate", soFar.texcoords, total.texcoords);
    if (second < corner.size() && corner.size() > second + 1 && !parseInteger(corner.substr(second + 1)))
      text.fail(fmt::format("expected a corner like 1/2/3, got '{}'", corner.substr(0, 40)));
  }
  if (corners < 3) text.fail(fmt::format("expected a face of at least 3 corners, got {}", corners));
}

}  // namespace

void checkObj(const std::string& file, std::string& content) {
  const Counts total = countAll(file, content);
  Counts soFar;
  MeshText text(file, content);
  while (text.nextLine()) {
    const std::string_view key = text.word();
    if (key == "v") {
      checkNumbers(text, 3, "a vertex");
      ++soFar.vertices;
    } else if (key == "vt") {
      checkNumbers(text, 2, "a texture coordinate");
      ++soFar.texcoords;
    } else if (key == "f") {
      checkFace(text, soFar, total);
    } else if (text.lineBegin() < content.size() && content[text.lineBegin()] != '\n') {
      content[text.lineBegin()] = '#';  // normals, groups, materials: not ours to read
    }
  }
}

}  // namespace loomlight
