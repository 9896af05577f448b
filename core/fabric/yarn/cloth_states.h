#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Where a sett is known from.
enum class SettSource {
  unknown,
  cloth,  ///< it is that of the fabric, which the picture shows
  mill,   ///< the mill has counted it (MillData)
  reed,   ///< reed and denting
  crimp,  ///< reckoned back from the finished cloth, whose crimped yarns once lay straight
};

struct KnownSett {
  double per_cm = 0;  ///< 0 where it is unknown
  SettSource source = SettSource::unknown;
};

/// The cloth at one time of its making.
struct ClothState {
  KnownSett ends, picks;
};

/// One cloth from the loom to the wash, with the same threads in it. The states are defined in the glossary:
/// words::reedState, loomState, finishedState, washedState.
struct ClothStates {
  ClothState reed;
  ClothState loom;
  ClothState finished;
  ClothState washed;
};

/// How much longer the threads are than the cloth that they lie in, as its geometry measures them (ClothMeasures).
struct Crimps {
  double warp = 0, weft = 0;
};

/// Nothing is reckoned from crimps that are not known yet.
ClothStates clothStates(const Fabric& fabric, const std::optional<Crimps>& crimps);

/// By how many percent the cloth gets smaller across the threads that were counted; nullopt where a sett is unknown.
std::optional<double> shrinkage_percent(const KnownSett& before, const KnownSett& after);

/// Ends of one dent, the empty ones counted.
double meanEndsPerDent(const MillData& mill);

/// How wide a piece lies in the reed, with its selvedges; nullopt where the ends in the reed are unknown.
std::optional<double> reedWidth_cm(const Fabric& fabric, const ClothStates& states, double finishedWidth_cm);

/// "24.5 /cm" with ~ before what is reckoned, or a dash.
std::string settText(const KnownSett& sett, const char* unknown = "\xE2\x80\x93");
/// In a few words: "reed and denting".
const char* sourceText(SettSource source);

/// Ends per dent as the mill writes them: "2", "3 3 0"; and read. nullopt where it is no such list.
std::string dentingText(const std::vector<int>& endsPerDent);
std::optional<std::vector<int>> dentingFromText(const std::string& text);

/// "24 each side, 4 per dent, plain"; empty where there are none. `yarn`: what the yarn is called.
std::string selvedgeText(const MillData& mill, const std::string& yarn);

}  // namespace loomlight
