#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/fabric/model/fabric.h"

/// The file format of fabrics: JSON, UTF-8. A key that is left out has its default; keys that this version does not
/// know are kept and written back, in every object; numbers have the units of their keys and the ranges of
/// field_tables.h. Every key: `loomlight schema --keys`, which fabric_schema.h makes of these tables.
namespace loomlight {

inline constexpr int kFabricVersion = 1;
/// Larger than any fabric that is valid.
inline constexpr size_t kMaxFabricBytes = 280'000'000;

struct FabricReading {
  Fabric fabric;
  std::vector<std::string> remarks;  ///< sentences: what looks otherwise than when the file was written
};

/// Throws InputError, naming `sourceName`, the place, and what was expected there, for anything but a valid fabric.
FabricReading fabricReadingOf(std::string_view text, const std::string& sourceName);
/// The same, without remarks.
Fabric fabricFromJson(std::string_view text, const std::string& sourceName);
/// The text of a fabric's file. Equal fabrics give the same bytes, and fabricFromJson() gives an equal fabric back.
std::string fabricToJson(const Fabric& fabric);

/// The meshes and environments that a fabric names, as `file` holds their names: relative to its folder where they lie
/// in it or below, else absolute. So the file can be read from another working directory, and moved with its folder.
Fabric localNames(Fabric fabric, const std::string& file);
/// The reverse: as seen from the working directory.
Fabric workingNames(Fabric fabric, const std::string& file);

/// The fabric of a file, with workingNames(). Throws InputError.
FabricReading openFabric(const std::string& file);
/// The same, without remarks.
Fabric readFabric(const std::string& file);
/// Writes whole or not at all (writeFileAtomically), with localNames(). Throws InputError when the file cannot be
/// written, or the fabric is not valid. False where it was stopped in time.
bool writeFabric(const Fabric& fabric, const std::string& file, const std::stop_token& stop = {});

}  // namespace loomlight
