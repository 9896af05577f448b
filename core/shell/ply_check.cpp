#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "core/shell/mesh_check.h"
#include "core/shell/mesh_file.h"
#include "core/shell/mesh_text.h"

// How it works. Before OpenMesh reads a PLY, its header is parsed and its body gone through, text or binary, without
// trusting a count: there must be vertices with x, y, z and texture coordinates, then faces whose one list names 3
// corners or more, and as many values as the header announces. What passes cannot make the reader take more memory
// than the file is worth, or read beyond it. Cost: one pass over the file.

namespace loomlight {
namespace {

enum class PlyFormat { ascii, littleEndian, bigEndian };

struct PlyProperty {
  std::string name;
  size_t bytes = 0;       ///< of the value, or of an element of the list
  size_t countBytes = 0;  ///< of the list's count; 0: no list
};

struct PlyElement {
  std::string name;
  size_t count = 0;
  std::vector<PlyProperty> properties;

  bool has(std::string_view property) const {
    return std::any_of(properties.begin(), properties.end(), [&](const auto& p) { return p.name == property; });
  }
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  const PlyElement* find(std::string_view name) const {
    const auto found = std::find_if(elements.begin(), elements.end(), [&](const auto& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
  }
};

size_t sizeOfType(const MeshText& text, std::string_view type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32" || type == "float" || type == "float32")
    return 4;
  if (type == "double" || type == "float64") return 8;
  text.fail(fmt::format("expected the type of a property (char to float64), got '{}'", type.substr(0, 40)));
}

PlyFormat parseFormat(const MeshText& text, std::string_view word) {
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::littleEndian;
  if (word == "binary_big_endian") return PlyFormat::bigEndian;
  text.fail("expected 'format ascii', 'binary_little_endian' or 'binary_big_endian'");
}

PlyProperty parseProperty(MeshText& text) {
  PlyProperty property;
  std::string_view type = text.word();
  if (type == "list") {
    const std::string_view count = text.word();
    property.countBytes = sizeOfType(text, count);
    if (count.starts_with("float") || count == "double") text.fail("expected a whole number to count a list");
    type = text.word();
  }
  property.bytes = sizeOfType(text, type);
  property.name = text.word();
  return property;
}

PlyHeader parseHeader(MeshText& text) {
  PlyHeader header;
  if (!text.nextLine() || text.word() != "ply") text.fail("expected a PLY file, which begins with 'ply'");
  while (text.nextLine()) {
    const std::string_view key = text.word();
    if (key == "end_header") return header;
    if (key == "comment" || key == "obj_info") continue;
    if (key == "format") {
      header.format = parseFormat(text, text.word());
      if (text.word() != "1.0") text.fail("expected version 1.0 of the format");
    } else if (key == "element") {
      PlyElement element;
      element.name = text.word();
      const std::optional<int64_t> count = parseInteger(text.word());
      if (!count || *count < 0 || *count > static_cast<int64_t>(3 * kMaxMeshTriangles))
        text.fail(fmt::format("expected a number of elements, at most {}", 3 * kMaxMeshTriangles));
      element.count = static_cast<size_t>(*count);
      header.elements.push_back(std::move(element));
    } else if (key == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(parseProperty(text));
    } else {
      text.fail(fmt::format("expected a line of a PLY header, got '{}'", key.substr(0, 40)));
    }
    if (const std::string_view more = text.word(); !more.empty())
      text.fail(fmt::format("expected the end of the header's line, got '{}'", more.substr(0, 40)));
  }
  text.fail("the file ends within its header; expected end_header");
}

/// What the reader can make sense of: vertices with x y z u v, then faces with one list of vertices each.
void checkElements(const MeshText& text, const PlyHeader& header) {
  const PlyElement* vertex = header.find("vertex");
  const PlyElement* face = header.find("face");
  if (!vertex || !face || vertex > face) text.fail("expected elements 'vertex' and then 'face'");
  if (!vertex->has("x") || !vertex->has("y") || !vertex->has("z")) text.fail("expected vertex properties x, y, z");
  if (!(vertex->has("u") && vertex->has("v")) && !(vertex->has("s") && vertex->has("t")))
    text.fail("no texture coordinates: expected vertex properties u and v (or s and t)");
  for (const PlyElement& element : header.elements) {
    for (const PlyProperty& property : element.properties) {
      const bool vertices = property.name == "vertex_indices" || property.name == "vertex_index";
      if (property.countBytes > 0 && !(&element == face && vertices))
        text.fail(
            fmt::format("cannot read the list '{}' of {}; expected texture coordinates at vertices and "
                        "no lists but the faces' vertex_indices",
                        property.name.substr(0, 40), element.name.substr(0, 40)));
    }
    if (&element == face) break;  // what follows is not read
  }
  if (!face->has("vertex_indices") && !face->has("vertex_index")) text.fail("expected the faces' list vertex_indices");
}

void checkAsciiBody(MeshText& text, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    for (size_t i = 0; i < element.count; ++i) {
      if (!text.nextLine())
        text.fail(fmt::format("the file ends early: expected {} {} of {}", element.name, i, element.count));
      for (const PlyProperty& property : element.properties) {
        int64_t values = 1;
        if (property.countBytes > 0) {
          values = parseInteger(text.word()).value_or(0);
          if (values < 3 || values > kMaxCorners)
            text.fail(fmt::format("expected a face of 3 to {} corners", kMaxCorners));
        }
        for (int64_t k = 0; k < values; ++k) {
          const std::string_view word = text.word();
          if (property.countBytes > 0 ? !parseInteger(word) : !parseCoordinate(word))
            text.fail(fmt::format("expected a number for '{}', got '{}'", property.name, word.substr(0, 40)));
        }
      }
      if (!text.word().empty()) text.fail(fmt::format("expected no more values for this {}", element.name));
    }
    if (element.name == "face") return;
  }
}

/// The count of a list, 1, 2 or 4 bytes.
uint64_t readCount(const char* bytes, size_t size, PlyFormat format) {
  uint64_t value = 0;
  for (size_t i = 0; i < size; ++i) {
    const size_t at = format == PlyFormat::bigEndian ? i : size - 1 - i;
    value = value << 8 | static_cast<unsigned char>(bytes[at]);
  }
  return value;
}

void checkBinaryBody(const std::string& file, const std::string& content, size_t offset, const PlyHeader& header) {
  const auto need = [&](size_t bytes, const PlyElement& element, size_t i) {
    if (content.size() - offset < bytes)
      throw InputError(
          fmt::format("{}: the file ends early: expected {} {} of {}", file, element.name, i, element.count));
  };
  for (const PlyElement& element : header.elements) {
    for (size_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        size_t bytes = property.bytes;
        if (property.countBytes > 0) {
          need(property.countBytes, element, i);
          const uint64_t corners = readCount(content.data() + offset, property.countBytes, header.format);
          if (corners < 3 || corners > kMaxCorners)
            throw InputError(
                fmt::format("{}: face {}: expected 3 to {} corners, got {}", file, i, kMaxCorners, corners));
          offset += property.countBytes;
          bytes *= corners;
        }
        need(bytes, element, i);
        offset += bytes;
      }
    }
    if (element.name == "face") return;
  }
}

}  // namespace

void checkPly(const std::string& file, const std::string& content) {
  MeshText text(file, content);
  const PlyHeader header = parseHeader(text);
  checkElements(text, header);
  if (header.format == PlyFormat::ascii) return checkAsciiBody(text, header);
  if (content.find('\r') < text.nextBegin())
    text.fail("expected header lines that end in a line feed alone in a binary file");
  checkBinaryBody(file, content, text.nextBegin(), header);
}

}  // namespace loomlight
