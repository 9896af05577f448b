#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/absorption.h"
#include "core/fabric/model/check.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_info.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/model/unknown_keys.h"
#include "core/fabric/model/validate.h"

/// Values of a fabric's file, one by one. Each function throws InputError, which names the place and what was expected.
namespace loomlight::from_json {

using nlohmann::json;

/// A value, for the "got" of a message.
std::string shown(const json& value);

int readWhole(const json& value, double min, double max, const FieldPath& path);
const json::array_t& readList(const json& value, const char* expected, const FieldPath& path);

// A field, held to its range.
void read(const json& value, const FieldInfo& info, const FieldPath& path, double& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, int& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, std::optional<int>& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, std::optional<double>& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, uint64_t& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, bool& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, std::string& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, Rgb& out);
void read(const json& value, const FieldInfo& info, const FieldPath& path, glm::dvec3& out);
/// Either a list with a number for each band, or an object that says where its values lie.
void read(const json& value, const FieldInfo& info, const FieldPath& path, Spectrum& out);
/// Three numbers, or what is known beyond them.
void read(const json& value, const FieldInfo& info, const FieldPath& path, Absorption& out);

template <class Enum>
void read(const json& value, const FieldInfo&, const FieldPath& path, Enum& out)
  requires std::is_enum_v<Enum>
{
  const std::optional<Enum> choice =
      value.is_string() ? choiceFromName<Enum>(value.get_ref<const std::string&>()) : std::nullopt;
  if (!choice) path.reject(choiceList<Enum>(), shown(value));
  out = *choice;
}

/// An object whose known keys are taken out one by one; what remains is what this version does not know.
class ObjectReader {
 public:
  ObjectReader(json value, const FieldPath& path) : object_(std::move(value)), path_(path) {
    if (!object_.is_object()) path_.reject("an object", shown(object_));
  }

  std::optional<json> take(const char* key) {
    const auto found = object_.find(key);
    if (found == object_.end()) return std::nullopt;
    std::optional<json> value(std::move(*found));
    object_.erase(found);
    return value;
  }

  bool has(const char* key) const { return object_.contains(key); }
  bool has(const char* key, const char* keyInIt) const {
    const auto found = object_.find(key);
    return found != object_.end() && found->is_object() && found->contains(keyInIt);
  }

  /// The value of a key, where it is there.
  template <class Value>
  void take(const char* key, const FieldInfo& info, Value& out) {
    if (const std::optional<json> value = take(key)) read(*value, info, path_.at(key), out);
  }

  template <class Object>
  void takeFields(Object& object) {
    forEachField<Object>([&](const auto& field) {
      if (const std::optional<json> value = take(field.info.key))
        read(*value, field.info, path_.at(field.info.key), object.*field.member);
    });
  }

  /// Of a value that has no place for what this version does not know.
  void expectNoMore(const char* expected) const {
    if (!object_.empty()) path_.reject(expected, quotedText(object_.begin().key()));
  }

  UnknownKeys rest() const { return object_.empty() ? nullptr : std::make_shared<const std::string>(object_.dump()); }

 private:
  json object_;
  const FieldPath& path_;
};

template <class Object>
Object readObject(json value, const FieldPath& path) {
  ObjectReader reader(std::move(value), path);
  Object object;
  reader.takeFields(object);
  object.unknown = reader.rest();
  return object;
}

template <class Object>
std::vector<Object> readObjects(json value, const FieldPath& path) {
  readList(value, "a list of objects", path);
  std::vector<Object> objects;
  for (size_t i = 0; i < value.size() && i <= kMaxKinds; ++i)
    objects.push_back(readObject<Object>(std::move(value[i]), path.at(i)));
  return objects;
}

/// Of numbers that an object has only where it needs them; else none.
std::vector<double> takeNumbers(ObjectReader& reader, const char* key, const FieldInfo& info, const FieldPath& path);

}  // namespace loomlight::from_json
