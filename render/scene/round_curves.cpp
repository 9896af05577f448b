#include "render/scene/round_curves.h"

namespace loomlight {

RTCGeometry RoundCurves::geometry(RTCDevice device, RTCFilterFunctionN filter, void* user) const {
  RTCGeometry curves = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  rtcSetSharedGeometryBuffer(curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, vertices_.data(), 0,
                             sizeof(glm::vec4), vertices_.size());
  rtcSetSharedGeometryBuffer(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, segments_.data(), 0, sizeof(uint32_t),
                             segments_.size());
  rtcSetGeometryUserData(curves, user);
  rtcSetGeometryIntersectFilterFunction(curves, filter);
  rtcSetGeometryOccludedFilterFunction(curves, filter);
  rtcCommitGeometry(curves);
  return curves;
}

bool RoundCurves::isFromInside(const RTCFilterFunctionNArguments& args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args.ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args.hit);
  return ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z > 0;
}

}  // namespace loomlight
