#pragma once

// Embree 3 (Debian 12) and Embree 4 (Debian 13) differ in how a query is handed over; only this file knows how.
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
/// The nearest hit, as rtcIntersect1 of either version.
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& query) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &query, &arguments);
}
/// Any hit, as rtcOccluded1 of either version: `query.tfar` is negative then.
inline void occluded(RTCScene scene, QueryContext& context, RTCRay& query) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &query, &arguments);
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
#endif

}  // namespace loomlight::embree
