#include "ui/dialogs/display_colours.h"

#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

const std::string& nameOf(DisplayColours::Source source, const ProfileNames& names) {
  static const std::string kStandard = "sRGB", kNone = "none: shown as sRGB";
  const std::string& name = source == DisplayColours::Source::system ? names.system : names.display;
  if (source == DisplayColours::Source::srgb) return kStandard;
  return name.empty() ? kNone : name;
}

}  // namespace

bool displayColourRows(Ui& ui, const ProfileNames& names, DisplayColours& colours) {
  heading(ui, "Colours of the display");
  static constexpr const char* kSources[] = {"sRGB", "System", "File"};
  int source = static_cast<int>(colours.source);
  segmentField(
      ui,
      {"preferences.display_profile", "Display profile",
       "By what colours are brought to this display: as sRGB, by the profile (ICC) that the system has for the "
       "display, or by that of a file. Files that are written stay sRGB."},
      kSources, source);
  colours.source = static_cast<DisplayColours::Source>(source);
  readout(ui, {"preferences.display_profile_name", "In use", "What the profile calls itself."},
          nameOf(colours.source, names));
  readout(ui,
          {"preferences.printer_profile_name", "Printer to proof",
           "View > Soft proof shows the cloth as this one prints it."},
          names.printer.empty() ? "none" : names.printer);
  return button(ui, "preferences.choose_profile", "Choose a profile\xE2\x80\xA6", 0, true,
                "An ICC file (.icc, .icm). That of a display is used for this one, that of a printer is proofed.");
}

}  // namespace loomlight
