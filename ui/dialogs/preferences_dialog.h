#pragma once

#include "ui/dialogs/display_colours.h"
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
  DisplayColours& colours;
  double& rulerFactor;     ///< how much longer a millimetre of the display is than the system says
  int& samples;            ///< a pixel, at which the picture rests
  double& fibreMemory_GB;  ///< what the fibres of the truth lens may take
};

class PreferencesDialog {
 public:
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  /// What there is to say beside the values.
  struct Facts {
    int mostSamples = 1;       ///< that a pixel may be asked for
    double machine_GB = 0;     ///< the memory that there is
    double pixels_per_mm = 0;  ///< of the display, as the system says
    ProfileNames profiles;
  };
  /// True: a colour profile is to be chosen.
  bool draw(Ui& ui, const Facts& facts, PreferenceValues values);

 private:
  bool open_ = false, opening_ = false;
};

}  // namespace loomlight
