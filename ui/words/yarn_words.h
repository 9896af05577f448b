#pragma once

#include "core/fabric/model/glossary.h"

/// What the page of a yarn says.
namespace loomlight::words::yarnPage {

// The yarns of the cloth
inline constexpr Word copy{"New from this", "Add a yarn that begins as a copy of this one"};
inline constexpr Word remove{"Remove", "A yarn can be removed when no end and no pick uses it"};
inline constexpr Word preset{"Start from",
                             "A yarn of the trade to start from: count, twist, bulk and hairs, and its fibre; the "
                             "colour stays."};
inline constexpr const char* tradeYarns = "Trade yarns";

// The pictures of it
inline constexpr const char* closeUp = "This yarn under a sky, every fibre traced as it is.";
inline constexpr const char* round = "{} mm across";
inline constexpr const char* summary = "{} \xC2\xB7 {} \xC2\xB7 {:.0f} fibres";  // its count, its size

// What it is spun of
inline constexpr Word blend{words::blendedWith.label,
                            "A second fibre spun together with the first, evenly mixed: two dyes make a melange. Both "
                            "lie with their mean thickness. A new fibre begins as the first one, to be dyed on the "
                            "fibre's page."};
inline constexpr const char* noBlend = "Nothing";
inline constexpr const char* newFibre = "A new fibre";

// Count
inline constexpr Word massBy{"Fineness by",
                             "A spinner says how thick a yarn is by its count. For few, coarse fibres it is easier to "
                             "say how many there are."};
inline constexpr const char* massWays[] = {words::count.label, "Fibres"};
inline constexpr Word typedCount{
    words::count.label,
    "How thick the yarn is. Typed counts are understood in every system: 30/2 Ne, 2/60 Nm, 150 den, 20 tex x 2, and of "
    "cables 20/2/3 Ne. Plies and cabling are set with it, and with filaments, 167 dtex f48, the fineness of the "
    "fibre."};
inline constexpr const char* countLooksLike = "a count like 30/2 Ne or 167 dtex f48";
inline constexpr const char* blendHasNoFilaments = "A blend has no filaments of one fineness: give its count alone";
inline constexpr const char* filamentsBeyondFibres = "Filaments of {:.3g} dtex are beyond what a fibre can be";

// Twist
inline constexpr const char* typedTwist = "{} Typed twists may be in t/m, tpi or TM.";

// Local visibility
inline constexpr Word visibility{"Local visibility",
                                 "How freely light reaches a fibre past its neighbours (the yarn's BVDF, which the "
                                 "estimator \"Report\" uses)"};
inline constexpr const char* visibilityAxes =
    "Down a square, the eye goes from straight above the cloth to grazing; to the right, the light goes from straight "
    "above to straight below. From square to square the light turns about the cloth's normal, away from the eye, which "
    "looks across the yarn.";
inline constexpr const char* visibilityBegins = "Measuring begins\xE2\x80\xA6";
inline constexpr const char* visibilityProgress = "White: free. Black: in shadow.  \xC2\xB7  measuring, {:.0f} %";
inline constexpr const char* visibilityDone = "White: free. Black: in shadow.  \xC2\xB7  {:.1f} million rays";

}  // namespace loomlight::words::yarnPage
