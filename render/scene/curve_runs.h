#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/yarn/cell_strands.h"
#include "render/scene/curve_run.h"
#include "render/scene/embree.h"

namespace loomlight {

/// A ray's question to curves, as Embree carries it to them. Who asks derives from it what `sees` needs to know.
struct CurveQuery {
  /// Whether the ray sees a segment, whose surface it comes to from outside at t.
  using Sees = bool (*)(const CurveQuery& query, uint32_t segment, float t);

  explicit CurveQuery(Sees s) : sees(s) { embree::initialise(embree); }

  embree::QueryContext embree;  ///< first, so that Embree's pointer to it is a pointer to the whole
  Sees sees;
};

/// The strands of a cell as round curves, of which rays see the outside only. Embree keeps a tree of short runs of
/// segments and asks us where a ray meets these. Such a tree takes a tenth of the time, and less memory, than one of
/// Embree's own curves (round_curves.h), by which rays among millions of fibres are quicker; and what is met is the
/// same to the last bit on every processor.
class CurveRuns {
 public:
  /// placeOf(point of CellStrands): where that lies, in mm.
  template <class PlaceOf>
  CurveRuns(const CellStrands& cell, const PlaceOf& placeOf);

  // A segment is a number; not all numbers have one.
  glm::vec3 tangent(uint32_t segment) const { return runOf(segment).tangent(segment % CurveRun::kSegments); }  ///< unit
  float radius_mm(uint32_t segment) const { return runOf(segment).radius_mm(); }
  uint32_t strandOf(uint32_t segment) const { return parts_[segment / CurveRun::kSegments].curve; }
  size_t bytes() const { return runs_.size() * (sizeof(CurveRun) + sizeof(CurvePart)); }

  /// A geometry that reads these very curves, which must stay as they are; every query must be a CurveQuery. A hit's
  /// primID is the segment, its normal is not of unit length. The caller releases the geometry.
  RTCGeometry geometry(RTCDevice device) const;

 private:
  const CurveRun& runOf(uint32_t segment) const { return runs_[segment / CurveRun::kSegments]; }
  void add(std::span<const glm::vec3> line, float radius_mm, uint32_t strand);
  /// visit(segment, t, normal) for each segment of a run that the ray comes into.
  template <class Visit>
  void forEachHit(uint32_t run, const RTCRay& ray, const Visit& visit) const;
  static void bound(const RTCBoundsFunctionArguments* arguments);
  static void intersect(const RTCIntersectFunctionNArguments* arguments);
  static void occlude(const RTCOccludedFunctionNArguments* arguments);

  std::vector<CurveRun> runs_;    ///< Embree's primitives
  std::vector<CurvePart> parts_;  ///< of each: its strand
};

template <class PlaceOf>
CurveRuns::CurveRuns(const CellStrands& cell, const PlaceOf& placeOf) {
  size_t runs = 0;
  for (const CellStrands::Strand& strand : cell.strands)
    runs += (strand.count + CurveRun::kSegments - 2) / CurveRun::kSegments;
  runs_.reserve(runs);
  parts_.reserve(runs);
  std::vector<glm::vec3> line;
  for (size_t s = 0; s < cell.strands.size(); ++s) {
    const CellStrands::Strand& strand = cell.strands[s];
    line.clear();
    for (const glm::vec3& point : std::span(cell.points).subspan(strand.first, strand.count))
      line.push_back(placeOf(point));
    add(line, cell.fibreRadius_mm, static_cast<uint32_t>(s));
  }
}

}  // namespace loomlight
