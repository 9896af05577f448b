#pragma once

#include <optional>
#include <string>

#include "ui/commands.h"
#include "ui/ui.h"
#include "ui/weave_menu.h"

namespace loomlight {

struct MenuModel {
  std::string title;  ///< the fabric's name
  bool edited = false;
  bool canUndo = false, canRedo = false;
  bool darkTheme = true;
  bool panelsShown = true;
  bool lensOn = false;
  WeaveMenuModel weave;
};

struct MenuChoice {
  std::optional<Command> command;
  std::optional<DraftCommand> draft;
};

/// The line at the top of the window.
MenuChoice menuBar(Ui& ui, const MenuModel& model);

}  // namespace loomlight
