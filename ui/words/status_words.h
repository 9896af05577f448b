#pragma once

/// What the status bar says: of the cloth, and of the work on its picture.
namespace loomlight::words::status {

// The cloth
inline constexpr const char* massHelp = "Areal mass: what one square metre of this cloth weighs.";
inline constexpr const char* cover = "cover {:.0f} %";
inline constexpr const char* coverHelp =
    "Share of the area that yarns hide when the cloth is seen flat, from straight above, as wide as they are pressed. "
    "Peirce's cover factors, on the page of the cloth, are another figure: how many threads there are for their "
    "thickness, were they round.";
inline constexpr const char* thickness = "{:.2f} mm thick";
inline constexpr const char* endlessFloat = "endless float";
inline constexpr const char* longestFloat = "longest float {} ({:.1f} mm)";
inline constexpr const char* longFloats = "{}, {} over {:.1f} mm";
inline constexpr const char* floatHelp =
    "The most crossings that a thread passes over or under without interlacing, and how many floats of one repeat are "
    "longer than the limit set beside Floats: long ones snag.";

// What is said in the place of the cloth's warnings, as it is more urgent
inline constexpr const char* figuresUnknown = "The cloth's figures are not known: ";
inline constexpr const char* viewNotKept = "The view that was kept will not last: ";
inline constexpr const char* workNotSafe = "Unsaved work is not kept safe: ";

// How light is stopped within yarns, measured in the background
inline constexpr const char* borrowed = "borrowed {:3.0f} %";
inline constexpr const char* visibility = "visibility {:3.0f} %";
inline constexpr const char* visibilityHelp =
    "How often light is stopped within the yarns is measured in the background, to be used once it is known. Until "
    "then it is lent by the most similar yarns that have been measured before.";

inline constexpr const char* lamp = "under {}";
inline constexpr const char* lampHelp =
    "The lamp whose spectrum the colours are seen by, as in a light booth (J takes the next, which is no edit of the "
    "cloth). The eye is adapted to "
    "it: white is white, and what moves is what dyers call metamerism.";

// The work, and what has helped the picture that is shown meanwhile
inline constexpr const char* workHelp = "What the workers behind the picture are doing.";
inline constexpr const char* firstLook = "first look{}";
inline constexpr const char* waiting = "waiting{}";
inline constexpr const char* building = "building {:3.0f} %{}";
inline constexpr const char* refining = "refining{}";
inline constexpr const char* recoloured = "recoloured{}";
inline constexpr const char* recolouredRefining = "recoloured, refining";
inline constexpr const char* converged = "converged{}";
inline constexpr const char* andDenoised = ", denoised";
inline constexpr const char* andShared = ", shared";
inline constexpr const char* andSmoothed = ", smoothed";

inline constexpr const char* samplesHelp =
    "Samples per pixel: light paths traced through every pixel. More is smoother.";
inline constexpr const char* secondsHelp = "Time since this picture was begun.";

}  // namespace loomlight::words::status
