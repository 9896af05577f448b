#pragma once

namespace loomlight {

/// What a panel asks the editor to do, beside editing the fabric.
enum class Command {
  newFabric,
  open,
  save,
  saveAs,
  savePreset,
  snapshot,
  chooseMesh,
  chooseEnvironment,
  quit,
  undo,
  redo,
  fitView,
  fitDraft,
  togglePanels,
  fullScreen,
  darkTheme,
  lightTheme,
  showKeys,
  showAbout,
};

}  // namespace loomlight
