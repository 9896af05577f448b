#pragma once

#include <optional>
#include <string>

#include "ui/commands.h"
#include "ui/ui.h"

namespace loomlight {

struct MenuModel {
  std::string title;  ///< the fabric's name
  bool edited = false;
  bool canUndo = false, canRedo = false;
  bool darkTheme = true;
  bool panelsShown = true;
  bool lensOn = false;
};

/// The line at the top of the window.
std::optional<Command> menuBar(Ui& ui, const MenuModel& model);

}  // namespace loomlight
