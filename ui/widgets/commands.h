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
  flatRepeat,  // the cloth lies flat: one repeat of the pattern, four by four, so many centimetres
  flatRepeats,
  flat5cm,
  flat10cm,
  flat20cm,
  sheet,
  brushBefore,
  softProof,  // the picture as a printer prints it
  gamutWarning,
  brushNext,
  swapBrushes,
  truthLens,
  boothLamp,  // the next of those that a light booth has
  denoise,
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
