#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The names of an enumeration's values, in their order: for files, command line and menus.
template <class Enum>
struct ChoiceNames;

template <>
struct ChoiceNames<FibreSection> {
  static constexpr std::array names{"round", "kidney", "triangle", "trilobal", "serrated", "polygon"};
};
template <>
struct ChoiceNames<TwistDirection> {
  static constexpr std::array names{"s", "z"};
};
template <>
struct ChoiceNames<FibreLayout> {
  static constexpr std::array names{"random", "packed"};
};
template <>
struct ChoiceNames<DrapeKind> {
  static constexpr std::array names{"flat", "cylinder", "sphere", "folds", "cushion", "skirt", "mesh"};
};
template <>
struct ChoiceNames<LightKind> {
  static constexpr std::array names{"sky",     "overcast", "window",    "booth",       "dome",
                                    "furnace", "back",     "headlight", "directional", "environment"};
};
template <>
struct ChoiceNames<StandardIlluminant> {
  static constexpr std::array names{"d65",    "d55",    "d50",    "a",      "e",      "f2",         "f7",  "f11",
                                    "led_b1", "led_b2", "led_b3", "led_b4", "led_b5", "black_body", "file"};
};
template <>
struct ChoiceNames<Observer> {
  static constexpr std::array names{"2_degrees", "10_degrees"};
};
template <>
struct ChoiceNames<Method> {
  static constexpr std::array names{"volume", "fibres"};
};
template <>
struct ChoiceNames<Estimator> {
  static constexpr std::array names{"none", "report", "loomlight"};
};
template <>
struct ChoiceNames<EventLaw> {
  static constexpr std::array names{"projected", "report"};
};

template <class Enum>
constexpr const char* choiceName(Enum value) {
  return ChoiceNames<Enum>::names[static_cast<size_t>(value)];
}

template <class Enum>
constexpr std::optional<Enum> choiceFromName(std::string_view name) {
  const auto& names = ChoiceNames<Enum>::names;
  for (size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return static_cast<Enum>(i);
  return std::nullopt;
}

/// All names of an enumeration as prose: "random" or "packed".
template <class Enum>
std::string choiceList() {
  const auto& names = ChoiceNames<Enum>::names;
  std::string list;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += '"' + std::string(names[i]) + '"';
  }
  return list;
}

}  // namespace loomlight
