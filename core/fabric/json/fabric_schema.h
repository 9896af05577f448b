#pragma once

#include <string>

namespace loomlight {

/// What may stand in a file of a fabric, as a JSON schema (draft 2020-12, json-schema.org): every key with its type,
/// range, default and a sentence of help. It is made of the field tables, so it cannot lag behind what is read.
std::string fabricSchema();

/// All keys of a fabric's file as a list for people: a line a key, objects indented.
std::string fabricKeys();

}  // namespace loomlight
