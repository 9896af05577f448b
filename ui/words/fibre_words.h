#pragma once

#include "core/fabric/model/glossary.h"

namespace loomlight::words {

/// What the page of a fibre says.
namespace fibrePage {

inline constexpr const char* fibreOf = "The fibre of {}.";
inline constexpr const char* alsoFibreOf = "Also the fibre of {}.";
inline constexpr const char* giveOwn = "Give this yarn its own";
inline constexpr Word ofBlend{"Of the blend", "This yarn is spun of two fibres."};
inline constexpr const char* fibresOfBlend[] = {"First", "Second"};

// Its kind, and where its numbers are from
inline constexpr Word preset{"Kind",
                             "Fills in fineness, optics and section, and keeps the colour, and a name of your own. The "
                             "numbers below say where they are from."};
inline constexpr const char* muchLike = "Much like {}";
inline constexpr const char* ownValues = "Own values";
inline constexpr const char* sourceOf = "{}\n\nOf {}: {}.";
inline constexpr const char* ownNumber = "{}\n\nYour own; {} has {:.{}f} {} ({}).";

inline constexpr const char* colour = "Colour";
inline constexpr const char* fineness = "Fineness";
inline constexpr const char* finenessLooksLike = "1.5 den or 18.5 mic";
inline constexpr const char* optics = "Optics";

// By what its absorption is known
inline constexpr const char* bands = "36 bands";
inline constexpr const char* threeDepths = "three depths";
inline constexpr const char* recipe = "a recipe of {} dyes";

}  // namespace fibrePage

/// What is said of the colour that the cloth should have, and of the one that it reaches.
namespace clothColour {

inline constexpr const char* difference =
    "\xCE\x94"
    "E {:.1f}";
inline constexpr const char* noDifference =
    "\xCE\x94"
    "E \xE2\x80\x93";
inline constexpr const char* dyed[] = {words::fibreName.label, words::yarnName.label, "Piece"};
inline constexpr const char* codeLooksLike = "Hex or Lab";
inline constexpr const char* codeOrNameLooksLike = "Hex, Lab or name";

inline constexpr const char* measuring = "Measuring what light does in this cloth.";
inline constexpr const char* yarnIsHidden = "This yarn never lies on the face, so it shows no colour.";
inline constexpr const char* fibreIsHidden = "This fibre never lies on the face, so it shows no colour.";
inline constexpr const char* failed = "The colour of this cloth cannot be measured.";
inline constexpr const char* pick = "Pick the colour that the cloth should have, or drop a measured swatch on a yarn.";
inline constexpr const char* notToBeHad = "Not to be had of this fibre; this is the nearest under {}.";
inline constexpr const char* tooLight =
    "Lighter than this cloth can be, as light comes through; this is the nearest under {}.";
inline constexpr const char* tooDark =
    "Darker than fibres can be, as their surface reflects; this is the nearest under {}.";
inline constexpr const char* asMeasured = "As {} was measured.";
inline constexpr const char* reached = "Reached.";
inline constexpr const char* clothChanged = "The cloth has changed since.";

}  // namespace clothColour

/// What stands in the rows of the colour book.
namespace bookRows {

inline constexpr const char* none = "None";
inline constexpr const char* forget = "Forget {}";
inline constexpr const char* dropHere = "Drop a palette here";
// Of a chip: its name, CIELAB, and the lamp and observer of that.
inline constexpr const char* colour = "{}\nL* {:.1f}  a* {:.1f}  b* {:.1f}  ({}, {}\xC2\xB0)";
inline constexpr const char* nothingFound = "No colour of {} has this in its name.";

}  // namespace bookRows
}  // namespace loomlight::words
