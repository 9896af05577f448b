#include "ui/dialogs/display_colours.h"

#include <fmt/core.h>

#include "ui/widgets/fields.h"
#include "ui/words/dialog_words.h"

namespace loomlight {
namespace {

const std::string& nameOf(DisplayColours::Source source, const ProfileNames& names) {
  static const std::string kStandard = words::preferences::srgb, kNone = words::preferences::noProfile;
  const std::string& name = source == DisplayColours::Source::system ? names.system : names.display;
  if (source == DisplayColours::Source::srgb) return kStandard;
  return name.empty() ? kNone : name;
}

}  // namespace

bool displayColourRows(Ui& ui, const ProfileNames& names, DisplayColours& colours) {
  const std::string about = fmt::format(words::preferences::profileHelp, nameOf(colours.source, names));
  segmentField(ui, {"preferences.display_profile", words::preferences::displayProfile, about.c_str()},
               words::preferences::profileSources, colours.source);
  const std::string aboutFiles = fmt::format(words::preferences::chooseProfileHelp,
                                             names.printer.empty() ? words::preferences::noPrinter : names.printer);
  return button(ui, "preferences.choose_profile", words::preferences::chooseProfile, 0, true, aboutFiles.c_str());
}

}  // namespace loomlight
