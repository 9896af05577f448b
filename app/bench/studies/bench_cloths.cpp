#include "app/bench/studies/bench_cloths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench_cloth_text.h"
#include "core/fabric/json/fabric_json.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/shell/drape_mesh.h"

namespace loomlight {
namespace {

std::vector<BenchCloth> read(std::initializer_list<std::pair<const char*, std::string_view>> files) {
  std::vector<BenchCloth> cloths;
  for (const auto& [name, json] : files) cloths.push_back({name, fabricFromJson(json, name)});
  return cloths;
}

}  // namespace

std::vector<BenchCloth> cylinderCloths() {
  return read({{"blue", kBenchBlueCloth},
               {"colourful", kBenchColourfulCloth},
               {"black_and_white", kBenchBlackAndWhiteCloth},
               {"green", kBenchGreenCloth}});
}

std::vector<BenchCloth> largeCloths() {
  return read({{"carpet", kBenchCarpet}, {"blanket", kBenchBlanket}, {"curtain", kBenchCurtain}});
}

double segmentsOf(const Fabric& fabric) {
  const int ends = std::max(1, static_cast<int>(std::ceil(fabric.drape.width_mm / fabric.warpPitch_mm() - 1e-4)));
  const int picks = std::max(1, static_cast<int>(std::ceil(fabric.drape.height_mm / fabric.weftPitch_mm() - 1e-4)));
  const ClothGeometry geometry(fabric, ends, picks);
  return geometry.measure().segmentsPerRepeat * ends / geometry.repeatEnds() * picks / geometry.repeatPicks();
}

Fabric rearranged(Fabric fabric) {
  // A drape is centred about its bounds, which sink as a cylinder is wrapped further.
  const auto top_mm = [&fabric] {
    float top = -std::numeric_limits<float>::max();
    for (const glm::vec3& position : makeDrape(fabric.drape).positions) top = std::max(top, position.z);
    return top;
  };
  const float before_mm = top_mm();
  const ClothGeometry geometry(fabric, 1, 1);
  fabric.drape.width_mm += 2 * geometry.repeatEnds() * fabric.warpPitch_mm();
  fabric.drape.height_mm += 2 * geometry.repeatPicks() * fabric.weftPitch_mm();
  fabric.camera.target_mm.z += top_mm() - before_mm;
  return fabric;
}

Fabric withSegments(Fabric fabric, double segments) {
  const double scale = std::sqrt(segments / segmentsOf(fabric));
  fabric.drape.width_mm = std::clamp(fabric.drape.width_mm * scale, 1.0, 1e4);
  fabric.drape.height_mm = std::clamp(fabric.drape.height_mm * scale, 1.0, 1e4);
  return fabric;
}

}  // namespace loomlight
