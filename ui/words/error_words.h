#pragma once

/// What went wrong in the editor, as it is told where it matters: in a message, below a field, in the status bar or in
/// the terminal. Errors of what is read and computed are told by those who read and compute.
namespace loomlight::words::errors {

inline constexpr const char* noWindow = "the window could not be opened: {}";
inline constexpr const char* noOpenGl = "the window could not be opened (OpenGL 3.3 is needed): {}";
inline constexpr const char* noReason = "no reason was given";
inline constexpr const char* shader = "display shader: {}";
inline constexpr const char* font = "the built-in font cannot be read";

inline constexpr const char* settingsNotKept = "loomlight: the settings of this session are not kept: {}\n";
inline constexpr const char* folderNotMade = "{}: the folder could not be made: {}";
inline constexpr const char* noView = "{}: expected a kept view, found no fabric in it";
inline constexpr const char* noFlatView = "{}: expected a piece of flat cloth that is looked at, got: {}";
inline constexpr const char* noSide = "{}: {}: expected \"{}\" or nothing, got another text";
inline constexpr const char* noLamp = "{}: {}: expected the name of a lamp or nothing, got \"{}\"";
inline constexpr const char* viewWithAlpha = "{}: expected a picture without alpha";

inline constexpr const char* presetFolderNotMade = "{}: the folder for presets could not be made: {}";
inline constexpr const char* notRemoved = "{}: could not be removed: {}";
inline constexpr const char* notPutBack = "{}: could not be put back: {}";
inline constexpr const char* notPutAside = "{}: could not be put aside: {}";
inline constexpr const char* nameIsTaken = "another preset has that name now: {}";
inline constexpr const char* noTags = "{}: expected the tags of presets";
inline constexpr const char* tagsGoElsewhere = "{}. New tags go into another file, and this one is kept beside it.";

// What an error calls what it is about
inline constexpr const char* thisEdit = "this edit";
inline constexpr const char* systemProfile = "the system's profile";

inline constexpr const char* noColour = "\"{}\" is no colour: expected #1a2b3c, Lab 30 5 -12{}.";
inline constexpr const char* orOfBook = ", or a name of {}";
inline constexpr const char* noColourBook = "{} holds one colour, no book of them";

}  // namespace loomlight::words::errors
