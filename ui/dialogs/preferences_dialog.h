#pragma once

#include "ui/draft/draft_view.h"
#include "ui/inspector/trade_units.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// What the interface can be scaled by, beside what the monitor asks for.
inline constexpr float kInterfaceSizes[] = {0.75f, 1.0f, 1.25f, 1.5f, 2.0f};

inline constexpr double kRulerFactor[] = {0.25, 4};  ///< from, to

/// What the editor is set to. Kept from one session to the next.
struct PreferenceValues {
  bool& darkTheme;
  float& interfaceSize;  ///< of kInterfaceSizes
  TradeUnits& units;
  DraftPreferences& draft;
  double& rulerFactor;     ///< how much longer a millimetre of the display is than the system says
  double& fibreMemory_GB;  ///< what the fibres of the truth lens may take
};

class PreferencesDialog {
 public:
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  /// `machine_GB`: the memory that there is; `pixels_per_mm`: of the display, as the system says.
  void draw(Ui& ui, double machine_GB, double pixels_per_mm, PreferenceValues values);

 private:
  bool open_ = false, opening_ = false;
};

}  // namespace loomlight
