#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include "core/fabric/model/fabric.h"

/// The file format of fabrics: JSON, UTF-8. A key that is left out has its default; keys that this version does not
/// know are kept and written back, in every object; numbers have the units of their keys and the ranges of
/// field_tables.h, where each object's keys are listed.
///
///   loomlight_version   1. Always there. Files of a newer version are refused.
///   name, description   texts
///   weave               one repeat as a list of texts, drawn as on point paper with pick 1 at the bottom: the first
///                       text is the last pick, and in it end 1 is on the left. "#" warp over weft, "." weft over warp
///   draft               instead of weave, how a loom makes it: shafts, treadles, rising_shed, threading (per end),
///                       tie_up (per treadle), treadling (per pick), or liftplan (per pick), which has the last word.
///                       Entries are a number or a list of them, from 1; 0 or [] for none. If weave is there as well,
///                       it must be what the draft makes.
///   ends_per_cm, picks_per_cm
///   warp_sequence       which yarn each end uses, from the left, repeating: numbers in the list of yarns, from 0
///   weft_sequence       which yarn each pick uses, from the bottom
///   yarns               objects: name, fibre (number in the list of fibres, from 0), count_tex or fibres_per_ply, ...
///                       and of a blend: blend_fibre, blend_share
///   fibres              objects: name, radius_um, refractive_index, absorption_per_mm [red, green, blue], ...
///   colourways          objects: name, absorption_per_mm [[red, green, blue], ...] in the order of the fibres
///   drape               object: kind "flat" | "cylinder" | "sphere" | "mesh", width_mm, height_mm, ...
///   light               object: kind "sky" | "dome" | "furnace" | "back" | "headlight" | "directional" | "environment"
///   camera              object: target_mm [x, y, z], azimuth_deg, elevation_deg, distance_mm, fov_deg
///   render              object: width, height, samples_per_pixel, seed, resolution, max_depth, method, estimator,
///                       event_law
///   wif                 of a fabric that came from a weaving file, what else that said: program, ends, picks,
///                       ends_per_cm, picks_per_cm, warp_diameter_mm, weft_diameter_mm (what the fabric was given when
///                       the file was read) and lines, the rest of the file as it would stand there
namespace loomlight {

inline constexpr int kFabricVersion = 1;
/// Larger than any fabric that is valid.
inline constexpr size_t kMaxFabricBytes = 280'000'000;

/// Throws InputError, naming `sourceName`, the place, and what was expected there, for anything but a valid fabric.
Fabric fabricFromJson(std::string_view text, const std::string& sourceName);
/// The same bytes for equal fabrics; reading them gives an equal one.
std::string fabricToJson(const Fabric& fabric);

/// The meshes and environments that a fabric names, as `file` holds their names: relative to its folder where they lie
/// in it or below, else absolute. So the file can be read from another working directory, and moved with its folder.
Fabric localNames(Fabric fabric, const std::string& file);
/// The reverse: as seen from the working directory.
Fabric workingNames(Fabric fabric, const std::string& file);

/// The fabric of a file, with workingNames(). Throws InputError.
Fabric readFabric(const std::string& file);
/// Writes whole or not at all (writeFileAtomically), with localNames(). Throws InputError when the file cannot be
/// written, or the fabric is not valid. False where it was stopped in time.
bool writeFabric(const Fabric& fabric, const std::string& file, const std::stop_token& stop = {});

}  // namespace loomlight
