#pragma once

/// What the editor asks, and what it says of what it was asked for.
namespace loomlight::words::messages {

inline constexpr const char* ok = "OK";
inline constexpr const char* windowTitle = "{} - Loomlight";
inline constexpr const char* windowTitleEdited = "{} (edited) - Loomlight";

// Work that is not saved
inline constexpr const char* unsavedTitle = "Unsaved work";
inline constexpr const char* unsaved = "\"{}\" has changes that are not saved.";
inline constexpr const char* dontSave = "Don't save";

// Work that an editor left which ended without saving it
inline constexpr const char* leftTitle = "Unsaved work was found";
inline constexpr const char* takeItUp = "{} Take it up again?";
inline constexpr const char* later = "Later";
inline constexpr const char* throwAway = "Throw away";
inline constexpr const char* takeUp = "Take up";
inline constexpr const char* left = "{} was last edited{}, and the editor ended before it was saved.";
inline constexpr const char* leftCloth = "\"{}\"";
inline constexpr const char* leftUnnamed = "A cloth";
inline constexpr const char* leftWhen = " on {} {:%B at %H:%M}";

// A file of the list of recent ones that is gone
inline constexpr const char* missingTitle = "This file is missing";
inline constexpr const char* missing = "{} is not there any more.";
inline constexpr const char* keepInList = "Keep in the list";
inline constexpr const char* forgetIt = "Forget it";

// What came of a file
inline constexpr const char* unopenedTitle = "This file cannot be opened";
inline constexpr const char* unknownKind =
    "{}: expected a cloth (.loomlight, .json), a draft (.wif, .plm, .dtx, .twa), a picture (.png), a mesh (.obj, .ply, "
    ".off), an environment (.exr), a palette (.ase, .aco, .gpl, .csv), a measured swatch (.cxf, .qtx, .csv, CGATS "
    ".txt), a lamp (two columns of text: nm and power) or a colour profile (.icc, .icm)";
inline constexpr const char* foreignDraft =
    "{0}: files of {1}'s own are not read. Save the draft as WIF in {1}, and open that";
inline constexpr const char* looksOtherwise = "It looks other than when it was saved";
inline constexpr const char* coloursRead = "The colours were read";
inline constexpr const char* unwovenTitle = "This picture cannot be used";
inline constexpr const char* unwrittenTitle = "The file could not be written";
inline constexpr const char* unwritten = "{}\n\nNothing is lost: the cloth is still here.";
inline constexpr const char* exported = "Exported";
inline constexpr const char* written = "Written: {}";

// What came of a preset
inline constexpr const char* presetUnusedTitle = "This preset cannot be used";
inline constexpr const char* presetsUnchanged = "The presets could not be changed";
inline constexpr const char* presetKeptTitle = "Kept as preset";
inline constexpr const char* presetKept = "\"{}\" is among the presets now.";

inline constexpr const char* aboutTitle = "Loomlight {}";
inline constexpr const char* about =
    "Woven cloth, seen as it will look: path-traced from the optics of its fibres.\n\n"
    "Pictures are written in sRGB with the white of daylight (D65). Apache License 2.0.";

}  // namespace loomlight::words::messages
