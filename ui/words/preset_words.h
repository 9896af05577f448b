#pragma once

#include "core/fabric/model/glossary.h"

namespace loomlight::words {

/// What is said of presets
namespace presets {

inline constexpr const char* title = "Presets";
inline constexpr const char* browseHelp = "Cloths to start from, by pictures (Ctrl+B)";
inline constexpr const char* choiceHelp = "Puts this cloth on the present drape, in the present light.";

// The browser
inline constexpr Word kind{"Show", "Yarns bring their fibre along; colours are those of all fibres."};
inline constexpr const char* kinds[] = {"Fabrics", "Yarns", "Fibres", "Colours"};
inline constexpr Word search{"Search", "Beginnings of words in names, descriptions and tags, such as: cotton twi"};
inline constexpr const char* coming = "One moment\xE2\x80\xA6";
inline constexpr Word name{"Name", "Of the chosen one; Rename gives it this name."};
inline constexpr const char* rename = "Rename";
inline constexpr Word tags{"Tags", "Words to find the chosen one by; Tag keeps them. Any preset can have some."};
inline constexpr const char* tag = "Tag";
inline constexpr const char* tagsBelow = "\nTags: {}";
inline constexpr Word use{"Use", "Double click and Enter do it too"};
inline constexpr Word keep{"Keep this", "Keep what the cloth has now"};
inline constexpr const char* duplicate = "Duplicate";

// What each is
inline constexpr const char* cloth = "{} ends, {} picks in the repeat; {:.0f} \xC3\x97 {:.0f} per cm";
inline constexpr const char* ply = "{} ply";
inline constexpr const char* plies = "{} plies";
inline constexpr const char* cabled = "{} x {}, cabled";
inline constexpr const char* fibre = "{:.1f} \u00B5m across, {:.2f} dtex";
inline constexpr const char* colour = "colour of one fibre";
inline constexpr const char* colours = "colours of {} fibres";

// What was done, and could be undone
inline constexpr const char* kept = "Kept";
inline constexpr const char* duplicated = "Duplicated as";
inline constexpr const char* done = "{} \"{}\".";
inline constexpr const char* renamed = "Renamed \"{}\" to \"{}\".";
inline constexpr const char* removed = "Removed \"{}\".";
inline constexpr const char* tagged = "Tagged \"{}\".";
inline constexpr const char* tooMany = "Not all is shown: with \"{}\" it would need more memory than there is.";

}  // namespace presets

/// What the cloths are called that come with the program
namespace samples {

inline constexpr const char* blueCloth = "Blue cloth";
inline constexpr const char* colourfulCloth = "Colourful cloth";
inline constexpr const char* blackAndWhiteCloth = "Black and white cloth";
inline constexpr const char* greenCloth = "Green cloth";
inline constexpr const char* denim = "Denim";
inline constexpr const char* sheerSilk = "Sheer silk";
inline constexpr const char* woolSuiting = "Wool suiting";
inline constexpr const char* jacquard = "Jacquard damask";

}  // namespace samples
}  // namespace loomlight::words
