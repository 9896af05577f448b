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
  static constexpr const char* kSources[] = {"sRGB", "System", "File"};
  int source = static_cast<int>(colours.source);
  const std::string about =
      "By what colours are brought to this display: as sRGB, by the profile (ICC) that the system has for the display, "
      "or by that of a file. Files that are written stay sRGB.\n\nIn use: " +
      nameOf(colours.source, names);
  segmentField(ui, {"preferences.display_profile", "Display profile", about.c_str()}, kSources, source);
  colours.source = static_cast<DisplayColours::Source>(source);
  const std::string aboutFiles =
      "An ICC file (.icc, .icm). That of a display is used for this one; View > Soft proof shows the cloth as a "
      "printer "
      "prints it.\n\nPrinter to proof: " +
      (names.printer.empty() ? "none" : names.printer);
  return button(ui, "preferences.choose_profile", "Choose a profile\xE2\x80\xA6", 0, true, aboutFiles.c_str());
}

}  // namespace loomlight
