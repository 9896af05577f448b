#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/fabric/fabric.h"

namespace loomlight {

/// One point of a yarn's path, at a crossing. Between nodes the path is arc, straight line, arc (Peirce), with a flat
/// top of half-length `flat_mm` for the flattened section it bends over (Kemp's racetrack).
struct PathNode {
  float height_mm = 0;  ///< of the yarn's axis above the mid-plane of the cloth
  float radius_mm = 0;  ///< of the arc
  float flat_mm = 0;
  bool operator==(const PathNode&) const = default;
};

/// All that the fibres of one yarn in one crossing cell depend on, and nothing more: equal keys have equal fibres,
/// voxel for voxel. Colour and optics are not in it.
struct CellKey {
  System system = System::warp;
  int yarn = 0;         ///< geometry class of the yarn: equal for yarns that differ only in colour
  int phase = 0;        ///< where in the yarn's own period this cell lies, 0 <= phase < YarnGeometry::period
  PathNode previous, here, next;
  bool operator==(const CellKey&) const = default;
};
uint64_t hash(const CellKey& key);

/// A yarn, resolved to lengths, as the geometry of one system (warp or weft) sees it. Its fibres repeat after `period`
/// cells, over which all twists make whole turns: that is what lets cells share one brick and still join seamlessly.
struct YarnGeometry {
  int plies = 1;
  int fibresPerPly = 1;
  double fibreRadius_mm = 0;   ///< chosen so that the whole number of fibres has exactly the yarn's count
  double plyRadius_mm = 0;
  double plyOrbit_mm = 0;      ///< distance of the ply axes from the yarn axis; 0 for a single ply
  double halfWidth_mm = 0;     ///< of the flattened yarn section, hairs excluded
  double halfHeight_mm = 0;
  double packing = 0;
  int period = 1;              ///< cells
  int plyTurns = 0;            ///< signed turns over one period; positive is Z (right-handed)
  int yarnTurns = 0;
  double pitch_mm = 0;         ///< length of a cell along the yarn
  double crossPitch_mm = 0;    ///< width of a cell across the yarn
  double migration = 0;
  double hairiness_per_mm = 0;
  double hairLength_mm = 0;
  FibreLayout layout = FibreLayout::packed;
  uint64_t seed = 0;
  double diameter_mm() const { return 2.0 * (plyOrbit_mm + plyRadius_mm); }  ///< round, before flattening
};

/// The fibres of one cell, as polylines. Local frame, mm: s along the yarn in [-pitch/2, pitch/2], u across it, z up;
/// u = s x z. For the warp (s, u) = (+y, +x); for the weft (s, u) = (+x, -y). Stored as vec3(u, s, z). Every point lies in
/// |u| <= 1.5 crossPitch: a yarn may spill into the cells beside its own, never further.
struct CellStrands {
  struct Strand {
    uint32_t first = 0;      ///< into points
    uint32_t count = 0;      ///< points, >= 2; segments = count - 1
    uint8_t ply = 0;
    uint8_t material = 0;    ///< which fibre of the yarn's blend; 0 for all of ours so far
    float packing = 0;       ///< local fibre volume fraction around it: the yarn's, 0 for loose hairs
  };
  std::vector<glm::vec3> points;
  std::vector<Strand> strands;
  float fibreRadius_mm = 0;

  size_t segments() const { return points.size() - strands.size(); }
};

/// Numbers a designer wants to see, from the geometry itself.
struct ClothMeasures {
  double thickness_mm = 0;
  double crimpWarp = 0;             ///< (length of yarn - length of cloth) / length of cloth
  double crimpWeft = 0;
  double arealMass_g_m2 = 0;        ///< of the yarns' counts, setts and crimps
  double segmentsPerRepeat = 0;
};

/// A flat piece of cloth of `ends` x `picks` crossings, as geometry: which key every cell of it has, and the fibres of
/// any key. Immutable, and small: no fibre is stored. Cell (pick, end) spans x in [end, end + 1) * warpPitch and y in
/// [pick, pick + 1) * weftPitch; the cloth's corner is the origin, z = 0 its mid-plane, +z its face.
class ClothGeometry {
 public:
  /// Throws nothing for a valid fabric (core/fabric/validate.h). `ends`, `picks`: size of the piece, >= 1.
  ClothGeometry(const Fabric& fabric, int ends, int picks);

  int ends() const { return ends_; }
  int picks() const { return picks_; }
  double warpPitch_mm() const { return warpPitch_mm_; }
  double weftPitch_mm() const { return weftPitch_mm_; }
  double halfThickness_mm() const { return halfThickness_mm_; }  ///< all fibres, hairs too, lie in |z| <= this
  double minYarnDiameter_mm() const;

  /// The yarn of `system` in cell (pick, end); any integers: the cloth goes on beyond its edges as its repeat does.
  CellKey key(System system, int pick, int end) const;
  const YarnGeometry& yarn(System system, int geometryClass) const;
  /// Index into Fabric::yarns of an end or a pick: for colour and optics, never for shape.
  int yarnIndex(System system, int index) const;

  /// Smallest periods, in crossings, after which key() repeats up to the phase.
  int repeatEnds() const { return repeatEnds_; }
  int repeatPicks() const { return repeatPicks_; }
  /// The key up to the phase: key(system, pick, end) with phase 0; and the phase alone.
  int phase(System system, int pick, int end) const;

  /// The fibres of a cell. A pure function of the key (and of this geometry's yarns).
  CellStrands strands(const CellKey& key) const;
  /// Length of the yarn's axis in the cell, mm.
  double axisLength_mm(const CellKey& key) const;

  ClothMeasures measure() const;

 private:
  struct SystemGeometry {
    std::vector<YarnGeometry> yarns;        ///< per geometry class
    std::vector<int> classOfYarn;           ///< Fabric::yarns index -> class
    std::vector<int> sequence;              ///< Fabric::yarns index per end or pick
  };
  std::array<SystemGeometry, 2> systems_;
  Weave weave_;
  int ends_ = 0, picks_ = 0, repeatEnds_ = 1, repeatPicks_ = 1;
  double warpPitch_mm_ = 0, weftPitch_mm_ = 0, halfThickness_mm_ = 0;
};

}  // namespace loomlight
