#include "ui/widgets/choices.h"

#include <cctype>

#include "core/fabric/model/choice_names.h"

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

std::span<const char* const> illuminantNames(const Light& light) {
  static constexpr const char* kNames[] = {"D65, daylight",   "D55, sunlight",  "D50, print booth",  "A, light bulb",
                                           "E, equal energy", "F2, cool white", "F7, daylight tube", "F11, shop (TL84)",
                                           "LED B1, 2700 K",  "LED B2, 3000 K", "LED B3, 4100 K",    "LED B4, 5100 K",
                                           "LED B5, 6600 K",  "Black body",     "Measured lamp"};
  return std::span(kNames).first(std::size(kNames) - (light.illuminantFile.empty() ? 1 : 0));
}

std::string lampName(StandardIlluminant lamp) {
  if (lamp == StandardIlluminant::blackBody) return "black body";
  if (lamp == StandardIlluminant::file) return "own lamp";
  std::string name = choiceName(lamp);
  for (char& c : name) c = c == '_' ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

StandardIlluminant nextLamp(StandardIlluminant lamp) {
  using enum StandardIlluminant;
  switch (lamp) {
    case d65:
      return f11;
    case f11:
      return a;
    case a:
      return ledB3;
    default:
      return d65;
  }
}

std::span<const char* const> observerNames() {
  static constexpr const char* kNames[] = {"2\xC2\xB0", "10\xC2\xB0"};
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
