#include <fmt/core.h>

#include "core/shell/mesh_check.h"
#include "core/shell/mesh_file.h"
#include "core/shell/mesh_text.h"

namespace loomlight {
namespace {

void blankComments(std::string& content) {
  for (size_t at = content.find('#'); at != std::string::npos; at = content.find('#', at))
    while (at < content.size() && content[at] != '\n') content[at++] = ' ';
}

/// Numbers of the line; fails at the first word that is none. Lines without words are skipped.
std::vector<double> numbersOfNextLine(MeshText& text, std::string_view what) {
  std::vector<double> numbers;
  while (numbers.empty()) {
    if (!text.nextLine()) text.fail(fmt::format("the file ends early: expected {}", what));
    for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
      const std::optional<double> number = parseCoordinate(word);
      if (!number) text.fail(fmt::format("expected {}, got '{}'", what, word.substr(0, 40)));
      numbers.push_back(*number);
      if (numbers.size() > kMaxCorners + 5) text.fail(fmt::format("expected {}, got a longer line", what));
    }
  }
  return numbers;
}

}  // namespace

void checkOff(const std::string& file, std::string& content) {
  MeshText text(file, content);
  text.nextLine();
  const std::string kind(text.word());
  if (kind != "STOFF" && kind != "STNOFF")
    text.fail(fmt::format("expected an ASCII OFF file with texture coordinates (first word STOFF or STNOFF), got '{}'",
                          kind.substr(0, 40)));
  if (!text.word().empty()) text.fail("expected nothing after STOFF on its line: only ASCII files can be read");
  blankComments(content);

  const std::vector<double> counts = numbersOfNextLine(text, "the numbers of vertices and faces");
  const double most = static_cast<double>(kMaxMeshTriangles);
  if (counts.size() < 2 || counts[0] < 0 || counts[1] < 0 || counts[0] > 3 * most || counts[1] > most ||
      counts[0] != std::floor(counts[0]) || counts[1] != std::floor(counts[1]))
    text.fail(fmt::format("expected the numbers of vertices and faces, the latter at most {}", kMaxMeshTriangles));

  const size_t perVertex = kind == "STOFF" ? 5 : 8;
  for (size_t i = 0; i < static_cast<size_t>(counts[0]); ++i) {
    const std::string what = fmt::format("{} numbers for vertex {}", perVertex, i);
    if (numbersOfNextLine(text, what).size() != perVertex) text.fail("expected " + what);
  }
  for (size_t i = 0; i < static_cast<size_t>(counts[1]); ++i) {
    const std::vector<double> face = numbersOfNextLine(text, fmt::format("face {}", i));
    if (!(face[0] >= 3 && face[0] <= kMaxCorners) || face.size() < static_cast<size_t>(face[0]) + 1)
      text.fail(fmt::format("expected face {} as its number of corners (3 to {}) and their vertices", i, kMaxCorners));
    for (size_t corner = 1; corner <= static_cast<size_t>(face[0]); ++corner)
      if (!(face[corner] >= 0 && face[corner] < counts[0]) || face[corner] != std::floor(face[corner]))
        text.fail(fmt::format("face names vertex {}, but the file has {}; expected 0 to {}", face[corner], counts[0],
                              counts[0] - 1));
  }
}

}  // namespace loomlight
