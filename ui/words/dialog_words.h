#pragma once

#include "core/fabric/model/glossary.h"

/// What dialogs say. Those of files, presets and pictures have files of their own.
namespace loomlight::words {

namespace colourways {

inline constexpr const char* title = "Colourways";
inline constexpr const char* asItIsNow = "As it is now";
inline constexpr const char* newName = "Colourway";
inline constexpr Word name{"Name", "What this colourway is called."};
inline constexpr Word keep{"Keep as it is", "Add the colours that the cloth has now"};
inline constexpr Word use{"Use", "Dye the cloth in these colours"};
inline constexpr Word duplicate{"Duplicate", "Add another one that begins as this one"};
inline constexpr Word print{"Print\xE2\x80\xA6", "A page with all of them at 1 : 1, as they look in a light booth"};

}  // namespace colourways

namespace preferences {

inline constexpr const char* title = "Preferences";
inline constexpr const char* look = "Look";
inline constexpr Word theme{"Theme", "The cloth is seen on the same grey in both."};
inline constexpr Word size{
    "Size of the interface",
    "100 % is what the monitor asks for. A small window holds it to what leaves room for the cloth."};
inline constexpr Word ruler{
    "A ruler reads",
    "Hold a ruler to the bar above and type what it reads: from then on 1 : 1 is 1 : 1 on this display."};
inline constexpr const char* units = "Units";
inline constexpr const char* usualPiece = "The usual piece";
inline constexpr const char* viewport = "Picture of the cloth";
inline constexpr const char *sample = "sample", *samples = "samples";
inline constexpr Word rest{
    "Picture rests at",
    "Samples a pixel: the picture grows clearer until it has so many, and then leaves the processor alone."};
inline constexpr Word lensMemory{
    "Lens takes at most",
    "The truth lens lays every single fibre of the piece. Where that would take more memory than this, it says so and "
    "leaves it."};

// How the display's colours are known
inline constexpr const char* displayProfile = "Display profile";
inline constexpr const char* srgb = "sRGB";
inline constexpr const char* profileSources[] = {srgb, "System", "File"};
inline constexpr const char* profileHelp =
    "By what colours are brought to this display: as sRGB, by the profile (ICC) that the system has for the display, "
    "or by that of a file. Files that are written stay sRGB.\n\nIn use: {}";
inline constexpr const char* noProfile = "none: shown as sRGB";
inline constexpr const char* chooseProfile = "Choose a profile\xE2\x80\xA6";
inline constexpr const char* chooseProfileHelp =
    "An ICC file (.icc, .icm). That of a display is used for this one; View > Soft proof shows the cloth as a printer "
    "prints it.\n\nPrinter to proof: {}";
inline constexpr const char* noPrinter = "none";

}  // namespace preferences

namespace structures {

inline constexpr const char* title = "Structures";
inline constexpr const char* facts = "{} ends, {} picks; floats of {} and {}";
inline constexpr const char* andShafts = "; {} shafts";
inline constexpr const char* andIsoCode = "; ISO 9354 {}";
inline constexpr const char* alikeYarns =
    "Both yarns look alike: dyed apart they show the effect, as it is drawn here.";
inline constexpr const char* fillsSelection = "It will fill the selection, {} by {} threads.";
inline constexpr const char* fillsRepeat = "It will be the whole repeat; select a part of the draft to fill only that.";
inline constexpr const char* apply = "Apply";

}  // namespace structures

namespace tile {

inline constexpr const char* title = "Texture tile";
inline constexpr const char* about =
    "One seamless tile as base colour, normal, height, opacity and yarn, for Blender, CLO, Substance and others. A "
    ".json beside them has its size in mm, mass and thickness.";
inline constexpr Word twist{
    "Twist joins",
    "On: the twist of every yarn comes round as well, so that each fibre goes on in the next tile; that may take "
    "several repeats. Off: weave and colours alone come round, and at the edges fibres do not quite meet."};
inline constexpr Word threads{"Threads", "Ends and picks of the tile"};
inline constexpr Word repeats{"Weave repeats", "Across and up the tile"};
inline constexpr Word size{"Size", "Of the tile, as cloth"};
inline constexpr Word longerSide{"Longer side", "Of the tile. At first 16 pixels for each thread, and 1024 at least."};
inline constexpr Word perThread{"Per thread", "Pixels across the finer of its threads"};
inline constexpr const char* tooFew = "Below {:g} pixels a thread is a mere colour, no yarn.";
inline constexpr Word samples{"Samples", "Light paths through every pixel: more are smoother."};
inline constexpr const char* perPixel = "per px";
inline constexpr Word file{"File", "The .json; the maps are named after it."};
inline constexpr const char* written = "Written: {}.json and {} maps beside it";

}  // namespace tile

namespace handover {

inline constexpr const char* title = "Hand-over";
inline constexpr const char* about =
    "Both sides of one seamless tile for CLO, Browzwear, Blender and others: maps, U3M, glTF and MaterialX, with what "
    "renderers of surfaces need fitted to this cloth. The .jfab for CLO is experimental: nobody has tried it there "
    "yet.";
inline constexpr Word measure{"To measure", "Light paths for each of the cameras that gloss and sheen are fitted to."};
inline constexpr const char* paths = "paths";
inline constexpr Word colourways{
    "All colourways", "On: beside the colours it has now, every colourway of the cloth, each in a folder of its own."};
inline constexpr Word folder{"Folder", "Made where there is none; the files are named after the cloth."};
inline constexpr const char* cancelled = "Cancelled; written whole: {} of {} folders";
inline constexpr const char* written =
    "Written: {} files; the fitted surface is off by {:.0f} % in front, {:.0f} % behind (RMS). In {}";

}  // namespace handover

namespace wif {

inline constexpr Word threads{"Threads",
                              "The file counts more threads than its draft names. The others hang on no shaft, or lift "
                              "none; they can be cut off."};
inline constexpr const char* threadChoices[] = {"All", "Named only"};
inline constexpr Word sizes{
    "Sett and thickness",
    "The cloth has the file's. Many programs write a default of their own here, whatever the cloth: keep yours then. "
    "Thick and thin threads keep their proportions either way."};
inline constexpr const char* sizeChoices[] = {"Keep mine", "The file's"};
inline constexpr const char* saysNoSizes = "It says nothing of sett and thickness; those of your cloth are kept.";
inline constexpr const char* warpYarn = "Warp yarn";
inline constexpr const char* weftYarn = "Weft yarn";
inline constexpr const char* oneWarning = "One thing in the file was read as it was probably meant";
inline constexpr const char* warnings = "Some things in the file were read as they were probably meant";

// What the draft is, and what it names of the cloth
inline constexpr const char* cloth = "\"{}\": {} ends, {} picks";
inline constexpr const char* andTreadles = ", {} treadles";
inline constexpr const char* andLiftplan = ", with a liftplan";
inline constexpr const char* writtenBy = ". Written by {}";
inline constexpr const char* named = "It names {} of {} ends and {} of {} picks.";

}  // namespace wif
}  // namespace loomlight::words
