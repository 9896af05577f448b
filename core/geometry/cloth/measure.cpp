#include <algorithm>
#include <map>
#include <unordered_map>

#include "core/geometry/cloth/cloth_geometry.h"
#include "core/geometry/yarn/stations.h"

namespace loomlight {
namespace {

/// Segments of the fibres of a cell, averaged over its phases.
double segmentsOf(const YarnModel& yarn, const YarnCellKey& key) {
  const YarnGeometry& g = yarn.geometry;
  const auto stations = layStations(yarn, key.previous, key.here, key.next, {}, g.pitch_mm);
  double steps = 0;
  for (size_t i = 0; i + 1 < stations.size(); ++i)
    if (stations[i + 1].s_mm > -0.5 * g.pitch_mm && stations[i].s_mm < 0.5 * g.pitch_mm) ++steps;
  double loose = 0;
  for (const Flyaway& f : yarn.flyaways) loose += (f.end - f.start) * steps + 1;
  return static_cast<double>(yarn.fibreCount()) * steps + loose / g.period;
}

/// The part that a yarn takes of the distance to its neighbours: the mean over a cell, in which its width goes from
/// that half-way to the crossing before, by its own crossing's, to that half-way to the next.
double widthShare(const YarnGeometry& yarn, const YarnCellKey& key) {
  constexpr int kSteps = 8;
  double sum = 0;
  for (const PathNode& other : {key.previous, key.next}) {
    const SectionEasing<SectionOutline> section({key.here.up, key.here.across}, {other.up, other.across}, yarn.free);
    for (int i = 0; i < kSteps; ++i) {
      const double width_mm = 2 * section.at(0.5 * (i + 0.5) / kSteps).across * yarn.radius_mm;
      sum += std::min(1.0, width_mm / yarn.crossPitch_mm);
    }
  }
  return sum / (2 * kSteps);
}

}  // namespace

ClothMeasures ClothGeometry::measure() const {
  const int ends = std::min(repeatEnds(), ends_), picks = std::min(repeatPicks(), picks_);
  std::array<std::vector<CellCount>, 2> counts;
  for (const System system : {System::warp, System::weft}) {
    std::unordered_map<ShapeCode, int64_t> cells;
    const bool warp = system == System::warp;
    std::vector<ShapeCode> codes(static_cast<size_t>(warp ? picks : ends));
    for (int across = 0; across < (warp ? ends : picks); ++across) {
      codes_.read(system, across, 0, codes);
      for (const ShapeCode code : codes) ++cells[code];
    }
    // Sorted, so that sums do not depend on the library's hashing.
    for (const auto& [code, count] : std::map<ShapeCode, int64_t>(cells.begin(), cells.end()))
      counts[static_cast<size_t>(system)].push_back({shapeKey(system, code), static_cast<double>(count)});
  }
  return measure(counts);
}

ClothMeasures ClothGeometry::measure(const std::array<std::vector<CellCount>, 2>& counts) const {
  const double cellsPerRepeat =
      static_cast<double>(std::min(repeatEnds(), ends_)) * static_cast<double>(std::min(repeatPicks(), picks_));
  ClothMeasures measures;
  double highest = 0, lowest = 0, open = 1;
  for (const System system : {System::warp, System::weft}) {
    double cells = 0, axis = 0, mass_g = 0, segments = 0, covered = 0;
    for (const CellCount& count : counts[static_cast<size_t>(system)]) {
      const YarnCellKey& key = count.shape;
      const YarnModel& model = yarns_.model(system, key.yarn);
      const YarnGeometry& g = model.geometry;
      const double length = count.cells * yarns_.axisLength_mm(key);
      cells += count.cells;
      axis += length;
      mass_g += length * g.count_tex * 1e-6;
      segments += count.cells * segmentsOf(model, key);
      covered += count.cells * widthShare(g, key);
      const double halfHeight = key.here.up * g.radius_mm;
      highest = std::max(highest, key.here.height_mm + halfHeight);
      lowest = std::min(lowest, key.here.height_mm - halfHeight);
    }
    const double pitch = system == System::warp ? weftPitch_mm() : warpPitch_mm();
    (system == System::warp ? measures.crimpWarp : measures.crimpWeft) = axis / (cells * pitch) - 1;
    measures.arealMass_g_m2 += mass_g / (cells * warpPitch_mm() * weftPitch_mm() * 1e-6);
    measures.segmentsPerRepeat += segments * (cellsPerRepeat / cells);
    open *= 1 - covered / cells;
  }
  measures.thickness_mm = highest - lowest;
  measures.cover = 1 - open;
  return measures;
}

}  // namespace loomlight
