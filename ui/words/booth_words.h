#pragma once

#include "core/fabric/model/glossary.h"

/// What is said where a cloth is judged by the lamps of a light booth.
namespace loomlight::words::booth {

inline constexpr Word tolerance{
    "Tolerance",
    "How far the cloth may be from what is wanted and still pass: CMC(2:1), as ISO 105-J03 has it for textiles."};
inline constexpr const char* toleranceUnit = "CMC";

inline constexpr Word present{"Under {}",  // the lamp of the cloth
                              "Wanted against reached under the lamp of the cloth, for the observer of "
                              "10\xC2\xB0, as dyers judge: CMC(2:1), which passes or fails. "
                              "A picked colour has no spectrum, and is judged in daylight (D65, 2\xC2\xB0)."};
inline constexpr Word worst{
    "Worst in {}",  // one of the booth's other lamps
    "The same under that of the light booth's other lamps by which the cloth is furthest from what was measured. Of a "
    "picked colour nothing is known there, as it has no spectrum."};
inline constexpr const char* worstOfNone = "Worst lamp";
inline constexpr Word metamerism{"Metamerism",
                                 "How much of the difference in the worst lamp is that lamp's doing: the CIEDE2000 "
                                 "that is left there of a pair made "
                                 "to match in daylight (special metamerism index, CIE 15)."};

// Two yarns of the cloth beside each other
inline constexpr const char* differenceTitle = "Colour difference";
inline constexpr Word standard{"Standard", "What the other is judged by."};
inline constexpr Word sample{"Sample", "What is judged."};
inline constexpr Word inColourway{"In colourway", "As the cloth is now, or in colours that it keeps under a name."};
inline constexpr const char* lamp = "Lamp";
inline constexpr const char* sideBySide = "As it looks";
inline constexpr const char* standardLab = "Standard L* a* b*";
inline constexpr const char* sampleLab = "Sample L* a* b*";
inline constexpr const char* ciede2000Column = "CIEDE2000";
inline constexpr const char* cmcColumn = "CMC(2:1)";
inline constexpr const char* howKnown =
    "Each colour is known to \xC2\xB1 {:.2f} CIEDE2000. Lit from everywhere, seen from above, for 10\xC2\xB0.";
inline constexpr const char* measuring = "Light is being traced through the cloth\xE2\x80\xA6";
inline constexpr const char* isHidden = "{} lies on top nowhere on the face, where its colour would be seen.";

inline constexpr const char* verdict = "{:.2f}  {}";  // CMC(2:1), and what follows from it
inline constexpr const char* passes = "pass";
inline constexpr const char* fails = "FAIL";
inline constexpr const char* figures = " CMC(2:1) {:.2f}, CIEDE2000 {:.2f}, known to \xC2\xB1 {:.2f}.";

}  // namespace loomlight::words::booth
