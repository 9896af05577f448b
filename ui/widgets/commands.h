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
  truthLens,
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
