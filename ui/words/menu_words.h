#pragma once

#include "core/fabric/model/glossary.h"

namespace loomlight {

/// A line of a menu, the keys that do it without the menu, and what is to be known of it.
struct MenuWord {
  const char* label;
  const char* keys = "";
  const char* help = "";
};

/// All that menus say.
namespace words::menu {

inline constexpr MenuWord file{"File"};
inline constexpr MenuWord edit{"Edit"};
inline constexpr MenuWord weave{"Weave"};
inline constexpr MenuWord view{"View"};
inline constexpr MenuWord help{"Help"};
inline constexpr MenuWord edited{"   \xE2\x97\x8F edited"};  // behind the cloth's name

// Of the frame
inline constexpr MenuWord newCloth{"New", "Ctrl+N"};
inline constexpr MenuWord openFile{"Open\xE2\x80\xA6", "Ctrl+O"};
inline constexpr MenuWord save{"Save", "Ctrl+S"};
inline constexpr MenuWord saveAs{"Save as\xE2\x80\xA6", "Ctrl+Shift+S"};
inline constexpr MenuWord savePreset{"Keep as preset"};
inline constexpr MenuWord presets{"Presets\xE2\x80\xA6", "Ctrl+B"};
inline constexpr MenuWord snapshot{"Snapshot\xE2\x80\xA6", "Ctrl+P"};
inline constexpr MenuWord sheet{"Cloth sheet\xE2\x80\xA6", ".pdf"};
inline constexpr MenuWord handover{"Hand-over\xE2\x80\xA6", ".u3m .glb"};
inline constexpr MenuWord quit{"Quit", "Ctrl+Q"};
inline constexpr MenuWord undo{"Undo", "Ctrl+Z"};
inline constexpr MenuWord redo{"Redo", "Ctrl+Shift+Z"};
inline constexpr MenuWord colourways{"Colourways\xE2\x80\xA6"};
inline constexpr MenuWord preferences{"Preferences\xE2\x80\xA6"};
inline constexpr MenuWord fit{"Fit the cloth", "Ctrl+0"};
inline constexpr MenuWord actualSize{"Actual size", "Ctrl+1"};
inline constexpr MenuWord fitDraft{"Fit the draft", "Shift+F"};
inline constexpr MenuWord keepView{"Keep this view", "K"};
inline constexpr MenuWord truthLens{"Truth lens", "L"};
inline constexpr MenuWord nextLamp{"Next lamp of the booth", "J",
                                   "The cloth is judged by one lamp of a light booth after the other, and by its own "
                                   "again at last, which it keeps."};
inline constexpr MenuWord boothSideBySide{"Booth side by side", "Shift+J"};
inline constexpr MenuWord colourDifference{"Colour difference\xE2\x80\xA6"};
inline constexpr MenuWord plainTone{
    "Plain tone, for judging colour", "",
    "Light is shown as it is, without a curve: in light of intensity 1 a perfect diffuser is the display's white, what "
    "is brighter is cut off, and exposure is 0. Without it what is bright is bent to fit, and the same white is shown "
    "at 85 % of the display's light. Cloth in the light booth is always shown plain."};
inline constexpr MenuWord denoise{"Denoised preview", "N"};
inline constexpr MenuWord gamutWarning{
    "Gamut warning", "Shift+Y",
    "Marks colours that are not shown as they are: with the soft proof on what the printer cannot print, without it "
    "what sRGB has not, in which the window is drawn."};
inline constexpr MenuWord panels{"Panels", "P"};
inline constexpr MenuWord fullscreen{"Full screen", "F11"};
inline constexpr MenuWord darkTheme{"Dark"};
inline constexpr MenuWord lightTheme{"Light"};
inline constexpr MenuWord keysAndMouse{"Keys and mouse", "F1"};
inline constexpr MenuWord about{"About Loomlight"};
inline constexpr MenuWord softProof{"Soft proof", "Y"};
inline constexpr MenuWord chooseProof{"Soft proof\xE2\x80\xA6", "Y"};

// Files opened before
inline constexpr MenuWord openRecent{"Open recent"};
inline constexpr MenuWord missing{"missing"};
inline constexpr MenuWord forgetAll{"Forget them all"};

// Flat cloth
inline constexpr MenuWord flatCloth{"Flat cloth"};
inline constexpr MenuWord oneRepeat{"One repeat"};
inline constexpr MenuWord repeats{"repeats"};
inline constexpr MenuWord asDraped{"As draped", "Esc"};
inline constexpr Word flatCount{"Repeats", "Of the pattern, each way"};
inline constexpr Word flatSide{"Side", "Of a square of cloth"};

// Weave and export
inline constexpr MenuWord shift{"Shift"};
inline constexpr MenuWord exportTo{"Export"};
inline constexpr MenuWord selectAll{"Select all", "Ctrl+A"};
inline constexpr MenuWord selectNothing{"Deselect", "Ctrl+D"};
inline constexpr MenuWord cut{"Cut", "Ctrl+X"};
inline constexpr MenuWord copy{"Copy", "Ctrl+C"};
inline constexpr MenuWord paste{"Paste", "Ctrl+V"};
inline constexpr MenuWord fillWithCopy{"Fill with the copy", "Ctrl+Shift+V"};
inline constexpr MenuWord weftOver{"Weft over", "Delete"};
inline constexpr MenuWord invert{"Invert", "Ctrl+I"};
inline constexpr MenuWord mirrorEnds{words::mirrorWarp.label};
inline constexpr MenuWord mirrorPicks{words::mirrorWeft.label};
inline constexpr MenuWord rotate{words::rotate.label};
inline constexpr MenuWord shiftLeft{"Left", "Left"};
inline constexpr MenuWord shiftRight{"Right", "Right"};
inline constexpr MenuWord shiftUp{"Up", "Up"};
inline constexpr MenuWord shiftDown{"Down", "Down"};
inline constexpr MenuWord cropToSelection{"Crop the repeat to the selection"};
inline constexpr MenuWord structures{"Structures\xE2\x80\xA6"};
inline constexpr MenuWord fromPicture{"From a picture\xE2\x80\xA6"};
inline constexpr MenuWord backOfCloth{words::backOfCloth.label};
inline constexpr MenuWord checkFloats{words::checkFloats.label};
inline constexpr MenuWord exportWif{"WIF draft\xE2\x80\xA6", ".wif"};
inline constexpr MenuWord exportBitmap{"Weave bitmap\xE2\x80\xA6", ".png .tif"};
inline constexpr MenuWord exportDraft{"Printed draft\xE2\x80\xA6", ".pdf .png"};
inline constexpr MenuWord exportTile{"Texture tile\xE2\x80\xA6", "Ctrl+E"};

}  // namespace words::menu
}  // namespace loomlight
