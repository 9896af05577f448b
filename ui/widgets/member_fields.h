#pragma once

#include <string>

#include "core/fabric/model/field_tables.h"
#include "ui/widgets/fields.h"

namespace loomlight {

/// Rows for the members of a fabric's values: label, unit, range and help come from the table that files and validation
/// use too, so the inspector cannot disagree with them. Tests know a row as prefix.key.
template <class Object, class Value>
RowText rowText(const char* prefix, Value Object::* member) {
  const FieldInfo info = fieldInfo(member);
  return {std::string(prefix) + "." + info.key, info.label, info.help};
}

template <class Object>
bool memberField(Ui& ui, const char* prefix, Object& object, double Object::* member, int decimals,
                 double perPixel = 0) {
  const FieldInfo info = fieldInfo(member);
  NumberStyle style;
  style.unit = info.unit;
  style.min = info.min;
  style.max = info.max;
  style.logarithmic = info.logarithmic;
  style.decimals = decimals;
  style.perPixel = perPixel;
  return numberField(ui, rowText(prefix, member), style, object.*member);
}

template <class Object>
bool memberField(Ui& ui, const char* prefix, Object& object, int Object::* member) {
  const FieldInfo info = fieldInfo(member);
  return wholeNumberField(ui, rowText(prefix, member), info.unit, static_cast<int>(info.min),
                          static_cast<int>(info.max), object.*member);
}

template <class Object, class Enum>
bool memberChoice(Ui& ui, const char* prefix, Object& object, Enum Object::* member,
                  std::span<const char* const> names) {
  int chosen = static_cast<int>(object.*member);
  const bool few = names.size() <= 2;
  const RowText text = rowText(prefix, member);
  if (!(few ? segmentField(ui, text, names, chosen) : choiceField(ui, text, names, chosen))) return false;
  object.*member = static_cast<Enum>(chosen);
  return true;
}

}  // namespace loomlight
