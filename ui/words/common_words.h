#pragma once

/// What several places say alike. Here and in all files of this folder, a text with {} is one that fmt::format fills
/// in, checked when it is compiled. Figures of digits, signs and units alone stand where they are made: they are no
/// words.
namespace loomlight::words::common {

inline constexpr const char* close = "Close";
inline constexpr const char* cancel = "Cancel";
inline constexpr const char* remove = "Remove";
inline constexpr const char* save = "Save";
inline constexpr const char* replace = "Replace";

inline constexpr const char* oneMoment = "One moment";
inline constexpr const char* nothingCalledThat = "Nothing is called that.";
inline constexpr const char* existsAlready = "{} exists already.";

// Of a cloth, and of a picture
inline constexpr const char* endsAndPicks = "{} ends, {} picks";
inline constexpr const char* andShafts = ", {} shafts";
inline constexpr const char* pixels = "{} \xC3\x97 {} pixels";
inline constexpr const char* preview = "preview";
inline constexpr const char* oneSample = "1 sample";
inline constexpr const char* samples = "{} samples";

}  // namespace loomlight::words::common
