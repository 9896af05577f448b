#include "ui/widgets/choices.h"

namespace loomlight {

std::span<const char* const> lightNames(const Light& light) {
  static constexpr const char* kNames[] = {"Sunny sky",  "Overcast",    "Window",    "Light booth",   "White dome",
                                           "All around", "From behind", "Headlight", "One direction", "Picture"};
  return std::span(kNames).first(std::size(kNames) - (light.file.empty() ? 1 : 0));
}

Light withKind(Light light, LightKind kind) {
  constexpr double kUsualElevation_deg = 45;
  light.kind = kind;
  if (kind == LightKind::sky && light.elevation_deg <= 0) light.elevation_deg = kUsualElevation_deg;
  return light;
}

std::span<const char* const> drapeNames(const Drape& drape) {
  static constexpr const char* kNames[] = {"Flat", "Cylinder", "Sphere", "Folds", "Cushion", "Skirt", "Mesh"};
  return std::span(kNames).first(std::size(kNames) - (drape.file.empty() ? 1 : 0));
}

std::span<const char* const> fibreSectionNames() {
  static constexpr const char* kNames[] = {"Round", "Kidney", "Triangle", "Trilobal", "Serrated", "Polygon"};
  return kNames;
}

std::span<const char* const> twistNames() {
  static constexpr const char* kNames[] = {"S", "Z"};
  return kNames;
}

std::span<const char* const> layoutNames() {
  static constexpr const char* kNames[] = {"Random", "Packed"};
  return kNames;
}

std::span<const char* const> methodNames() {
  static constexpr const char* kNames[] = {"Volume", "Fibres"};
  return kNames;
}

std::span<const char* const> estimatorNames() {
  static constexpr const char* kNames[] = {"None", "Report", "Loomlight"};
  return kNames;
}

std::span<const char* const> eventLawNames() {
  static constexpr const char* kNames[] = {"Projected", "Report"};
  return kNames;
}

}  // namespace loomlight
