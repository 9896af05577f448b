#pragma once

#include "core/fabric/model/glossary.h"

namespace loomlight::words {

/// What stands around the draft, and what the line below it says.
namespace draft {

inline constexpr Word select{"Select",
                             "Drag pulls a rectangle, to be copied, mirrored or given a structure; the right button "
                             "lists what can be done. Ctrl+drag selects at any time."};
inline constexpr Word inColour{"Colour", "The yarn that lies on top; else point paper: dark is warp over."};
inline constexpr Word back{"Back", words::backOfCloth.help};
inline constexpr Word floats{"Floats", words::checkFloats.help};

inline constexpr Word allStructures{"All structures\xE2\x80\xA6",
                                    "Every structure with its numbers, for the whole repeat or a selection."};

// Under the mouse
inline constexpr const char* crossing = "end {}, pick {}";
inline constexpr const char* endOfBar = "end {}: {}; a click gives it the selected yarn";
inline constexpr const char* pickOfBar = "pick {}: {}; a click gives it the selected yarn";
inline constexpr const char* threading = "threading: end {}, shaft {}; Ctrl: several";
inline constexpr const char* tieUp = "tie-up: treadle {}, shaft {}";
inline constexpr const char* treadling = "treadling: pick {}, treadle {}; Ctrl: several";
inline constexpr const char* liftplan = "liftplan: pick {}, shaft {}";
inline constexpr const char* setUnderLoom = "{} What the loom has is set under Loom, below.";  // behind a remark

}  // namespace draft

/// Floats that are too long.
namespace floats {

inline constexpr Word limit{"Over",
                            "Floats that are longer are marked: the length that lies free between the crossings that "
                            "bind it, on the face and on the back."};
inline constexpr const char* marked = "marked: floats longer than {:.1f} mm";
inline constexpr Word before{"<", "The float before"};
inline constexpr Word next{">", "The next float, from the longest on"};
inline constexpr const char* none = "none";
inline constexpr const char* one = "{} float";
inline constexpr const char* several = "{} floats";
inline constexpr const char* chosen = "{} of {}";

// One of them
inline constexpr const char* endNeverInterlaces = "end {} never interlaces";
inline constexpr const char* pickNeverInterlaces = "pick {} never interlaces";
inline constexpr const char* ofWarp = "{:.1f} mm warp float, {}, end {}, {}";  // its side, its end, what it is over
inline constexpr const char* ofWeft = "{:.1f} mm weft float, {}, pick {}, {}";
inline constexpr const char* face = "face";
inline constexpr const char* back = "back";
inline constexpr const char* overPick = "pick {}";
inline constexpr const char* overPicks = "picks {} to {}";
inline constexpr const char* overEnd = "end {}";
inline constexpr const char* overEnds = "ends {} to {}";

}  // namespace floats

/// What the page of the loom says.
namespace loomPage {

inline constexpr Word loom{"Loom",
                           "Treadles: threading, tie-up and treadling. Liftplan: the shafts of each pick, for a dobby. "
                           "Jacquard: every end by itself, drawn freely."};
inline constexpr const char* looms[] = {words::treadles.label, words::liftplan.label, "Jacquard"};
inline constexpr Word shed{"Shed",
                           "Rising: tied shafts go up. Sinking: they are pulled down. The tie-up is made anew, the "
                           "cloth stays."};
inline constexpr const char* sheds[] = {"Rising", "Sinking"};

// Why a row has no number
inline constexpr const char* ofJacquard = "None: as a jacquard every end is lifted by itself.";
inline constexpr const char* treadlesOfLiftplan = "None: the liftplan says which shafts each pick lifts.";
inline constexpr const char* shedOfLiftplan =
    "The liftplan says which shafts each pick lifts, so the shed is a rising one.";

inline constexpr Word endsOfRepeat{"Repeat, ends",
                                   "Warp threads until the weave repeats. A larger repeat goes on as the old one."};
inline constexpr Word picksOfRepeat{"Repeat, picks",
                                    "Weft threads until the weave repeats. A larger repeat goes on as the old one."};

inline constexpr const char* forAllDrafts = "For all drafts";
inline constexpr Word firstThread{"First thread", "The corner of the drawdown where end 1 and pick 1 are."};
inline constexpr const char* corners[] = {"Bottom left", "Bottom right", "Top left", "Top right"};
inline constexpr Word rulers{"Rulers", "Lengths along the drawdown, at the fabric's sett."};

}  // namespace loomPage
}  // namespace loomlight::words
