#pragma once

#include "core/fabric/model/glossary.h"

/// What is said of pictures: one that is woven, and those that are saved of the cloth.
namespace loomlight::words {

/// To weave from a picture
namespace picture {

inline constexpr const char* title = "Weave from a picture";
inline constexpr const char* isBeingRead = "{} is being read\xE2\x80\xA6";
inline constexpr const char* about = "{}: {} \xC3\x97 {} pixels";
inline constexpr const char* shownAs[] = {"Woven", "Colours"};
inline constexpr const char* shownHelp = "The cloth in its present yarns, or the colours that are told apart.";
inline constexpr Word into{"Fills", "The crossings that are selected in the draft, or the repeat: all of the weave."};
inline constexpr const char* intoNames[] = {"Selection", "Repeat"};
inline constexpr Word selection{"Ends and picks", "Of the selection, which the picture fills."};
inline constexpr Word ends{words::ends.label, "How many ends the picture is wide: the repeat of the weave."};
inline constexpr Word picks{words::picks.label, "How many picks it is high."};
inline constexpr Word proportions{"Picks in proportion",
                                  "As many picks as leave the picture its proportions, at the cloth's sett."};
inline constexpr Word colours{"Colours", "That are told apart."};
inline constexpr const char* structureHelp = "What is woven in the place of this colour.";
inline constexpr const char* dragToMerge = "Drag a colour on another to weave both alike.";
inline constexpr const char* weave = "Weave";
inline constexpr const char* weaving = "Weaving\xE2\x80\xA6";

// What a colour can be woven as, beside the structures of the draft
inline constexpr const char* warpOver = "Warp over";
inline constexpr const char* shadedSatin = "Shaded satin {}/8";

}  // namespace picture

namespace snapshot {

inline constexpr const char* title = "Snapshot";
inline constexpr Word file{"File",
                           "Where the picture goes: .png as the display shows it, .exr with all its light and layers"};
inline constexpr Word sizeIn{"Size in", "For a screen, or for a print of a size."};
inline constexpr const char* sizeUnits[] = {"Pixels", "Print, mm"};
inline constexpr Word width{"Width", "On paper"};
inline constexpr Word height{"Height", "On paper"};
inline constexpr Word resolution{"Resolution", "Pixels on an inch of paper: 300 for print, 150 for a large poster"};
inline constexpr Word pixels{"Pixels", "Of the picture"};
inline constexpr Word paper{"On paper", "How large the picture is printed at this resolution"};
inline constexpr Word scale{
    "Cloth on paper",
    "As seen: as much cloth as the viewport shows. 1 : 1: a centimetre of cloth is a centimetre of paper. Whole piece, "
    "of flat cloth: its repeats or centimetres and nothing beside them; the height follows the width."};
inline constexpr const char* scales[] = {"As seen", "1 : 1", "Whole piece"};
inline constexpr Word cloth{"Cloth shown", "Where the camera looks"};
inline constexpr Word scaleBar{"Scale bar",
                               "A bar of a round length below the picture, right where the camera looks; .png only."};
inline constexpr Word caption{"Caption", "Stands below the picture; .png only. Empty: none."};
inline constexpr const char* saved = "Saved {}";

}  // namespace snapshot

/// The work on a picture or a tile that is written to a file
namespace rendering {

inline constexpr const char* render = "Render";
inline constexpr const char* cancelled = "Cancelled; nothing was written.";

}  // namespace rendering
}  // namespace loomlight::words
