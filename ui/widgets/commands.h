#pragma once

namespace loomlight {

/// What a panel asks the editor to do, beside editing the fabric.
enum class Command {
  newFabric,
  open,
  save,
  saveAs,
  savePreset,
  presets,
  colourways,
  snapshot,
  keepView,
  chooseMesh,
  chooseEnvironment,
  quit,
  undo,
  redo,
  fitView,
  actualSize,
  sheet,
  handover,
  brushBefore,
  brushNext,
  swapBrushes,
  truthLens,
  boothLamp,        // the next of those that a light booth has
  boothSideBySide,  // all of them at once
  colourDifference,
  plainTone,
  denoise,
  softProof,  // the picture as a printer prints it
  gamutWarning,
  fitDraft,
  togglePanels,
  fullScreen,
  darkTheme,
  lightTheme,
  preferences,
  showKeys,
  showAbout,
};

}  // namespace loomlight
