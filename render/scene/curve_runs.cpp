#include "render/scene/curve_runs.h"

#include <algorithm>

namespace loomlight {
namespace {

template <class Arguments>
const CurveQuery& queryOf(const Arguments& arguments) {
  return *reinterpret_cast<const CurveQuery*>(arguments.context);
}

}  // namespace

void CurveRuns::add(std::span<const glm::vec3> line, float radius_mm, uint32_t strand) {
  const size_t last = line.size() - 1;
  for (size_t first = 0; first < last; first += CurveRun::kSegments) {
    const size_t segments = std::min<size_t>(CurveRun::kSegments, last - first);
    runs_.emplace_back(line.subspan(first, segments + 1), radius_mm);
    parts_.push_back({strand, first == 0, first + segments == last});
  }
}

RTCGeometry CurveRuns::geometry(RTCDevice device) const {
  RTCGeometry curves = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(curves, static_cast<unsigned>(runs_.size()));
  rtcSetGeometryUserData(curves, const_cast<CurveRuns*>(this));
  rtcSetGeometryBoundsFunction(curves, bound, nullptr);
  rtcSetGeometryIntersectFunction(curves, intersect);
  rtcSetGeometryOccludedFunction(curves, occlude);
  rtcCommitGeometry(curves);
  return curves;
}

void CurveRuns::bound(const RTCBoundsFunctionArguments* arguments) {
  const auto& curves = *static_cast<const CurveRuns*>(arguments->geometryUserPtr);
  const CurveRun& run = curves.runs_[arguments->primID];
  glm::vec3 lower = run.point(0), upper = lower;
  for (int i = 1; i <= CurveRun::kSegments; ++i) {
    lower = glm::min(lower, run.point(i));
    upper = glm::max(upper, run.point(i));
  }
  *arguments->bounds_o = embree::boundsAbout(lower - run.radius_mm(), upper + run.radius_mm());
}

template <class Visit>
void CurveRuns::forEachHit(uint32_t number, const RTCRay& ray, const Visit& visit) const {
  const CurveRun* const run = runs_.data() + number;
  const CurvePart& part = parts_[number];
  // From where the ray passes by: a fibre's radius is little beside a cell, and would drown in rounding.
  const glm::vec3 direction = embree::directionOf(ray), to = run->point(0) - embree::originOf(ray);
  const float near = glm::dot(to, direction) / glm::dot(direction, direction);
  const CurveRun::Hits hits =
      run->meet(embree::originOf(ray) + near * direction, direction, part, part.begins ? nullptr : run - 1);
  for (unsigned i = 0; hits.segments >> i; ++i) {
    const float t = near + hits.t[i];
    if ((hits.segments >> i & 1) && t >= ray.tnear && t <= ray.tfar)
      visit(number * CurveRun::kSegments + i, t, hits.normal[i]);
  }
}

/// Of segments that are met at the same t the first in order is taken, whatever order Embree asks in.
void CurveRuns::intersect(const RTCIntersectFunctionNArguments* arguments) {
  const auto& curves = *static_cast<const CurveRuns*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  const CurveQuery& asked = queryOf(*arguments);
  curves.forEachHit(arguments->primID, query.ray, [&](uint32_t segment, float t, glm::vec3 normal) {
    if (embree::isHit(query) && t == query.ray.tfar && segment > query.hit.primID) return;
    if (!asked.sees(asked, segment, t)) return;
    query.ray.tfar = t;
    query.hit.Ng_x = normal.x;
    query.hit.Ng_y = normal.y;
    query.hit.Ng_z = normal.z;
    query.hit.geomID = arguments->geomID;
    query.hit.primID = segment;
  });
}

void CurveRuns::occlude(const RTCOccludedFunctionNArguments* arguments) {
  const auto& curves = *static_cast<const CurveRuns*>(arguments->geometryUserPtr);
  auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  const CurveQuery& asked = queryOf(*arguments);
  curves.forEachHit(arguments->primID, ray, [&](uint32_t segment, float t, glm::vec3) {
    if (asked.sees(asked, segment, t)) embree::block(ray);
  });
}

}  // namespace loomlight
