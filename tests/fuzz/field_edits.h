#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "tests/fuzz/choices.h"

namespace loomlight::fuzz {

/// A number within a field's range, 255 steps from its beginning to its end, by ratios where sliders move so.
inline double numberIn(const FieldInfo& info, Choices& choices) {
  const double way = choices.below(256) / 255.0;
  const double number = info.logarithmic && info.min > 0 ? info.min * std::pow(info.max / info.min, way)
                                                         : info.min + way * (info.max - info.min);
  return std::clamp(number, info.min, info.max);
}

inline Rgb colourIn(const FieldInfo& info, Choices& choices) {
  Rgb colour;
  for (int channel = 0; channel < 3; ++channel) colour[channel] = static_cast<float>(numberIn(info, choices));
  return colour;
}

// Each of these gives a field another value that the inspector could give it.
inline void choose(double& value, const FieldInfo& info, Choices& choices) {
  value = numberIn(info, choices);
}
inline void choose(int& value, const FieldInfo& info, Choices& choices) {
  value = static_cast<int>(std::lround(numberIn(info, choices)));
}
inline void choose(uint64_t& value, const FieldInfo&, Choices& choices) {
  value = choices.below(256);
}
inline void choose(bool& value, const FieldInfo&, Choices&) {
  value = !value;
}
inline void choose(glm::dvec3& value, const FieldInfo& info, Choices& choices) {
  for (int axis = 0; axis < 3; ++axis) value[axis] = numberIn(info, choices);
}
inline void choose(std::string& value, const FieldInfo&, Choices& choices) {
  static constexpr std::array kTexts{
      "", "cotton", "silk, champagne", "polyester 2", "d\xC3\xA9j\xC3\xA0 \"vu\"\n", "/cloths/a.obj"};
  value = kTexts[choices.below(kTexts.size())];
}
/// Three numbers, bands, or a recipe.
inline void choose(Absorption& value, const FieldInfo& info, Choices& choices) {
  value = Absorption(colourIn(info, choices));
  const uint32_t kind = choices.below(4);
  if (kind == 0) return;
  const auto first = static_cast<float>(numberIn(info, choices)), last = static_cast<float>(numberIn(info, choices));
  Spectrum bands;
  for (size_t i = 0; i < kBands; ++i) bands[i] = std::lerp(first, last, static_cast<float>(i) / (kBands - 1));
  if (kind == 1)
    value = Absorption(bands);
  else
    value.dyes = {{"navy", numberIn(fieldInfo(&Dyestuff::amount_percent), choices), bands}};
}
template <class Enum>
  requires std::is_enum_v<Enum>
void choose(Enum& value, const FieldInfo&, Choices& choices) {
  value = static_cast<Enum>(choices.below(static_cast<uint32_t>(ChoiceNames<Enum>::names.size())));
}
/// Given or not.
template <class Value>
void choose(std::optional<Value>& value, const FieldInfo& info, Choices& choices) {
  if (choices.below(4) == 0) return value.reset();
  choose(value.emplace(), info, choices);
}

/// Edits one field of an object, as its row in the inspector does. Returns the stages that the field names.
template <class Object>
Stages editOneField(Object& object, Choices& choices) {
  constexpr auto kFields = static_cast<uint32_t>(std::tuple_size_v<decltype(FieldTable<Object>::fields)>);
  const uint32_t chosen = choices.below(kFields);
  Stages stages;
  uint32_t number = 0;
  forEachField<Object>([&](const auto& field) {
    if (number++ != chosen) return;
    choose(object.*field.member, field.info, choices);
    stages = field.info.stages;
  });
  return stages;
}

}  // namespace loomlight::fuzz
