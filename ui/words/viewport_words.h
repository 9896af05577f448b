#pragma once

#include "core/fabric/model/glossary.h"

/// What is said around the picture of the cloth.
namespace loomlight::words {

namespace viewport {

// On the picture
inline constexpr const char* building = "Building the cloth\xE2\x80\xA6";
inline constexpr const char* denoised = "Denoised";
inline constexpr const char* asPrinted = "As printed";
inline constexpr const char* plain = "Plain tone";
inline constexpr const char* warned = "Gamut warning";
inline constexpr const char* between = "  \xC2\xB7  ";  // of those that hold
inline constexpr const char* flat = "Flat \xC2\xB7 {}";
inline constexpr const char* crossing = "End {}, pick {}  \xC2\xB7  {}";

// Below it
inline constexpr Word light{"Light", "Light: what shines on the cloth"};
inline constexpr Word drape{"Drape", "Drape: the surface the cloth lies on"};
inline constexpr Word exposure{
    "Exposure",
    "Exposure: brightness of the display, in stops: +1 is twice as bright. It changes neither the light nor the cloth. "
    "How colours reach this display, as sRGB or by its profile (ICC), is chosen in the preferences."};
inline constexpr const char* noExposure = "0 EV";
inline constexpr const char* noExposureHelp =
    "Exposure: 0, as the tone is plain (menu View) and colours can be judged. The booth is always shown so.";
inline constexpr Word fit{"Fit", "Show the whole cloth (F)"};
inline constexpr const char* denoiseHelp =
    "Denoised preview (N): light is shared among pixels that noise alone sets apart. Fine detail may be lost until "
    "more samples have come. Snapshots and kept views never have it.";

}  // namespace viewport

/// The truth lens
namespace lens {

inline constexpr const char* help =
    "Truth lens (L): drag a rectangle over the cloth, and see the same pixels traced through every single fibre";
inline constexpr const char* dragRectangle = "Drag a rectangle over the cloth";
inline constexpr const char* closeHelp = "Close the lens (Esc)";
inline constexpr Word difference{
    "Difference",
    "Where the volume's brightness differs from the fibres' by more than noise explains. Black: no difference is "
    "known."};
inline constexpr Word fibres{"Fibres",
                             "The same pixels, traced through every single fibre of the cloth: no statistics"};
inline constexpr const char* remedyHelp = "Undo brings the old size back";
inline constexpr Word changeLimit{"Change the limit\xE2\x80\xA6", "How much memory the fibres of the lens may take"};

// What is seen through it
inline constexpr const char* waiting = "waiting for the cloth";
inline constexpr const char* laying = "laying {} fibre segments{}, {}: {:.0f} %";
inline constexpr const char* starting = "fibres, starting";
inline constexpr const char* seen = "fibres{}, {}";
inline constexpr const char* ofOneRepeat = " of one repeat";
inline constexpr const char* differenceWaiting = "difference, waiting for samples";
inline constexpr const char* differenceOfOne = "difference: not known of one sample a pixel";
inline constexpr const char* differenceSeen = "difference \xC3\x97{:g}, mean {} \xC2\xB1 {:.1f} %";
inline constexpr const char* thousand = "{:.0f} thousand";
inline constexpr const char* million = "{:.1f} million";
inline constexpr const char* billion = "{:.1f} billion";

// What is in its way
inline constexpr const char* needless =
    "The whole picture shows every fibre already. Choose the method Volume on the Scene page to compare the two.";
inline constexpr const char* tooLarge =
    "Every fibre of this piece, {} segments, would take {} of memory. The limit is {}. A smaller piece shows the "
    "same cloth{}.";
inline constexpr const char* orLaidFlat = "; laid flat, one repeat can stand for all of it";
inline constexpr const char* makeSmaller = "Make it {:g} \xC3\x97 {:g} mm";
inline constexpr const char* failed = "The fibres could not be laid: {}";

}  // namespace lens

/// Views that were kept
namespace views {

inline constexpr const char* choiceHelp = "A click chooses it; a double click brings its cloth and view back.";
inline constexpr Word keep{"Keep view", "Add the view as it is now (K)"};
inline constexpr Word compare{"Compare", "Choose two views to compare them"};
inline constexpr Word restore{"Restore", "Bring back the cloth and the view of the one chosen"};

// Two beside each other
inline constexpr Word way{"See them by",
                          "Slider: drag the line. Difference: black where they are alike, four times as bright as they "
                          "are apart, on the mean of 3 by 3 pixels, which evens out noise."};
inline constexpr const char* ways[] = {"Slider", "Side by side", "Difference"};

}  // namespace views
}  // namespace loomlight::words
