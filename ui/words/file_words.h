#pragma once

/// What is said where files are chosen, looked into, read and written.
namespace loomlight::words::files {

// The browser
inline constexpr const char* filter = "Show only names with\xE2\x80\xA6";
inline constexpr const char* up = "\xE2\x86\x91  Up";
inline constexpr const char* nothingHere = "Nothing here that this dialog can use.";
inline constexpr const char* tooManyHere =
    "Only the first {} entries of this folder were looked at. Type the name of one that is missing.";
inline constexpr const char* nameOrPath = "File name or path";
inline constexpr const char* noFolderHere = "No folder in this one.";
inline constexpr const char* folderOrPath = "Name of a new folder in this one, or path";
inline constexpr const char* isNoFolder = "{} is a file, and no folder.";
inline constexpr const char* take = "Choose";
inline constexpr const char* noName = "Type a name, or choose a file.";
inline constexpr const char* isNotThere = "There is no {}";
inline constexpr const char* open = "Open";
inline constexpr const char* choose = "Choose\xE2\x80\xA6";

// Places that are often looked in
inline constexpr const char* home = "Home";
inline constexpr const char* computer = "Computer";
inline constexpr const char* samples = "Samples";

// What is asked for
inline constexpr const char* saveCloth = "Save the cloth";
inline constexpr const char* chooseMesh = "Choose a mesh";
inline constexpr const char* chooseEnvironment = "Choose an environment";
inline constexpr const char* snapshotFile = "Where the snapshot goes";
inline constexpr const char* chooseProfile = "Choose a colour profile";
inline constexpr const char* choosePicture = "Choose a picture";
inline constexpr const char* exportWif = "Export as WIF draft";
inline constexpr const char* exportDraft = "Export the draft for print";
inline constexpr const char* tileFile = "Where the tile goes";
inline constexpr const char* handoverFolder = "Where the hand-over goes";
inline constexpr const char* sheetFile = "Where the cloth sheet goes";
inline constexpr const char* colourwaysFile = "Where the colourways go";
inline constexpr const char* exportWeave = "Export the weave";

// What a file is
inline constexpr const char* isLookedInto = "Looking into it\xE2\x80\xA6";
inline constexpr const char* tiny = "under 1 kB";
inline constexpr const char* tooLarge = "Too large to be looked into.";
inline constexpr const char* holdsNoCloth = "It holds no cloth.";
inline constexpr const char* cannotBeRead = "It cannot be read.";
inline constexpr const char* unnamedColour = "no. {}";  // of a colour book

// What is done with it
inline constexpr const char* opening = "Opening {}\xE2\x80\xA6";
inline constexpr const char* writing = "Writing {}\xE2\x80\xA6";
inline constexpr const char* finishing = "Finishing {}\xE2\x80\xA6";

// What is added to the cloth's name to name a file
inline constexpr const char* tileEnding = " tile.json";
inline constexpr const char* handoverEnding = " hand-over";
inline constexpr const char* sheetEnding = " sheet.pdf";
inline constexpr const char* colourwaysEnding = " colourways.pdf";

}  // namespace loomlight::words::files
