#pragma once

#include <optional>
#include <string>

#include "core/base/units.h"
#include "core/fabric/model/absorption.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_info.h"
#include "core/fabric/model/field_path.h"

namespace loomlight {

/// Longest text of a fabric, bytes.
inline constexpr size_t kMaxText = 65536;

/// Each of these throws InputError, naming the place, unless the value is one that its field allows.
void check(const FieldInfo& info, double value, const FieldPath& path);
void check(const FieldInfo& info, int value, const FieldPath& path);
void check(const FieldInfo& info, const std::optional<int>& value, const FieldPath& path);
void check(const FieldInfo& info, const std::optional<double>& value, const FieldPath& path);
void check(const FieldInfo& info, const Rgb& value, const FieldPath& path);
void check(const FieldInfo& info, const Spectrum& value, const FieldPath& path);
void check(const FieldInfo& info, const Absorption& value, const FieldPath& path);
void check(const FieldInfo& info, const glm::dvec3& value, const FieldPath& path);
void check(const FieldInfo& info, const std::string& value, const FieldPath& path);
inline void check(const FieldInfo&, uint64_t, const FieldPath&) {}
inline void check(const FieldInfo&, bool, const FieldPath&) {}
template <class Enum>
void check(const FieldInfo&, Enum value, const FieldPath& path)
  requires std::is_enum_v<Enum>
{
  if (static_cast<size_t>(value) >= ChoiceNames<Enum>::names.size())
    path.reject(choiceList<Enum>(), std::to_string(static_cast<int>(value)));
}

/// What a message expects: "a number from 0 to 5000", "a whole number from 1 to 8".
std::string expectedNumber(double min, double max);
std::string expectedWhole(double min, double max);

}  // namespace loomlight
