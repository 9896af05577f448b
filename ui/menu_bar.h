#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/draft/weave_menu.h"
#include "ui/flat_menu.h"
#include "ui/recent_menu.h"
#include "ui/widgets/commands.h"
#include "ui/widgets/ui.h"

namespace loomlight {

struct MenuModel {
  std::string title;  ///< the fabric's name
  bool edited = false;
  bool canUndo = false, canRedo = false;
  bool darkTheme = true;
  bool panelsShown = true;
  bool insetOn = false;
  bool denoised = false;
  bool boothSideBySide = false;
  bool plainTone = false;
  bool judgesColour = false;  ///< in a booth, where the tone is always plain
  bool proofs = false, warnsOfGamut = false;
  bool knowsPrinter = false;  ///< whose prints can be shown
  WeaveMenuModel weave;
  FlatMenuModel flat;
  std::span<const RecentFile> recent;
};

struct MenuChoice {
  std::optional<Command> command;
  std::optional<DraftCommand> draft;
  RecentMenuChoice recent;
  FlatMenuChoice flat;
};

/// The line at the top of the window.
MenuChoice menuBar(Ui& ui, const MenuModel& model);

}  // namespace loomlight
