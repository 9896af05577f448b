#pragma once

#include "ui/draft_view.h"
#include "ui/trade_units.h"
#include "ui/ui.h"

namespace loomlight {

/// What the editor is set to, beside how it looks. Kept from one session to the next.
struct PreferenceValues {
  TradeUnits& units;
  DraftPreferences& draft;
  double& fibreMemory_GB;  ///< what the fibres of the truth lens may take
};

class PreferencesDialog {
 public:
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  /// `machine_GB`: the memory that there is.
  void draw(Ui& ui, double machine_GB, PreferenceValues values);

 private:
  bool open_ = false, opening_ = false;
};

}  // namespace loomlight
