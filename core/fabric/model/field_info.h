#pragma once

#include <tuple>
#include <type_traits>

#include "core/fabric/model/stages.h"

namespace loomlight {

/// What is known of one editable value, stated once: an edit of it puts `stages` out of date, files name it by `key`,
/// the inspector shows `label`, `unit` and `help`, and both hold it to the range. Text, choices and switches have no
/// range.
struct FieldInfo {
  Stages stages;
  const char* key = "";    ///< in files; ends in the unit where there is one
  const char* label = "";  ///< in the inspector
  const char* unit = "";   ///< UTF-8, for display
  double min = 0;
  double max = 0;
  const char* help = "";     ///< one sentence for a designer
  bool logarithmic = false;  ///< a slider should move by ratios: the range spans decades
};

/// A data member and what is known of it.
template <class Object, class Value>
struct Field {
  Value Object::* member;
  FieldInfo info;
};
template <class Object, class Value>
Field(Value Object::*, FieldInfo) -> Field<Object, Value>;

/// Specialised for each value type of a fabric (field_tables.h): a tuple `fields` of all its plain members, in the
/// order in which files list them.
template <class Object>
struct FieldTable;

/// visit(const Field<Object, Value>&) for every plain member of Object.
template <class Object, class Visit>
constexpr void forEachField(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, FieldTable<Object>::fields);
}

/// The entry of one member: fieldInfo(&Yarn::plies).max is 8. A key of "" says that the table has none.
template <class Object, class Value>
constexpr FieldInfo fieldInfo(Value Object::* member) {
  FieldInfo found;
  forEachField<Object>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), Value Object::*>) {
      if (field.member == member) found = field.info;
    }
  });
  return found;
}

/// A new object that has the other's values where a field touches any of these stages, and else its own.
template <class Object>
Object onlyOf(Stages stages, const Object& other) {
  Object object;
  forEachField<Object>([&](const auto& field) {
    if (field.info.stages.any(stages)) object.*field.member = other.*field.member;
  });
  return object;
}

/// Whether all plain members are equal. Keys of other versions (UnknownKeys) are not plain members.
template <class Object>
bool equalFields(const Object& a, const Object& b) {
  bool equal = true;
  forEachField<Object>([&](const auto& field) { equal = equal && a.*field.member == b.*field.member; });
  return equal;
}

}  // namespace loomlight
