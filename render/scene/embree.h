#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>

// Embree 3 (Debian 12) and Embree 4 (Debian 13) differ in how a query is handed over and in who may build; only this
// file knows how.
#ifndef LOOMLIGHT_EMBREE_MAJOR
#error "Embree is for the sources of this room alone: LOOMLIGHT_EMBREE_MAJOR is not defined"
#elif LOOMLIGHT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace loomlight::embree {

#if LOOMLIGHT_EMBREE_MAJOR >= 4
/// What Embree carries from a query to the functions of the geometry; what a function of ours needs stands behind it.
using QueryContext = RTCRayQueryContext;

inline void initialise(QueryContext& context) {
  rtcInitRayQueryContext(&context);
}
/// As rtcIntersect1 of either version.
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& query) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &query, &arguments);
}
/// As rtcOccluded1 of either version.
inline void occluded(RTCScene scene, QueryContext& context, RTCRay& query) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &query, &arguments);
}
/// How many threads may build a scene, of those that there are. Where Embree 4 is told to stop, it throws out of a
/// task, which another thread may have taken by then: now and then that one ends the program in TBB (seen with
/// Embree 4.3 and oneTBB 2022, not with Embree 3.13 and 2021). One thread has nobody to take its tasks.
inline int builderThreads(int /*threads*/) {
  return 1;
}
#else
using QueryContext = RTCIntersectContext;

inline void initialise(QueryContext& context) {
  rtcInitIntersectContext(&context);
}
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& query) {
  rtcIntersect1(scene, &context, &query);
}
inline void occluded(RTCScene scene, QueryContext& context, RTCRay& query) {
  rtcOccluded1(scene, &context, &query);
}
inline int builderThreads(int threads) {
  return threads;
}
#endif

/// A box for Embree about what we meet by arithmetic of our own. Roomier, by a hundred roundings of its largest
/// coordinate: Embree's own, which differ by processor, decide nothing for rays from within so many times that
/// distance.
inline RTCBounds boundsAbout(glm::vec3 lower, glm::vec3 upper) {
  const glm::vec3 far = glm::max(glm::abs(lower), glm::abs(upper));
  const float slack = 1e-5f * std::max({far.x, far.y, far.z});
  return {lower.x - slack, lower.y - slack, lower.z - slack, 0, upper.x + slack, upper.y + slack, upper.z + slack, 0};
}

/// A ray whose hits count from tNear to tFar.
inline RTCRay rayOf(glm::vec3 origin, glm::vec3 direction, float tNear, float tFar) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tnear = tNear;
  ray.tfar = tFar;
  ray.mask = ~0u;
  return ray;
}
inline glm::vec3 originOf(const RTCRay& ray) {
  return {ray.org_x, ray.org_y, ray.org_z};
}
inline glm::vec3 directionOf(const RTCRay& ray) {
  return {ray.dir_x, ray.dir_y, ray.dir_z};
}
/// What a function of ours does to a ray that meets something, where it is only asked whether it does.
inline void block(RTCRay& ray) {
  ray.tfar = -std::numeric_limits<float>::infinity();
}
/// The ray with the nearest hit, at its tfar, if it has any.
inline RTCRayHit nearestHit(RTCScene scene, QueryContext& context, const RTCRay& ray) {
  RTCRayHit query{ray, {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect(scene, context, query);
  return query;
}
inline bool isHit(const RTCRayHit& query) {
  return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}
/// Whether it has no hit at all.
inline bool isFree(RTCScene scene, QueryContext& context, RTCRay ray) {
  occluded(scene, context, ray);
  return ray.tfar >= 0;  // negative where there was one
}

}  // namespace loomlight::embree
