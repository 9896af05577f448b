#pragma once

#include <optional>
#include <vector>

#include "core/fabric/yarn/derived.h"
#include "ui/inspector/cloth_colour.h"
#include "ui/inspector/trade_units.h"
#include "ui/inspector/visibility_section.h"
#include "ui/inspector/yarn_section.h"
#include "ui/widgets/commands.h"
#include "ui/widgets/crossing_index.h"
#include "ui/widgets/panel_controls.h"
#include "ui/widgets/ui.h"
#include "ui/widgets/yarn_colours.h"

namespace loomlight {

/// Which page is open and which yarn is looked at.
struct InspectorView {
  enum class Page { yarn, fibre, cloth, scene };
  Page page = Page::yarn;
  int yarn = 0;
  bool secondFibre = false;  ///< of a blend, on the page of fibres
  ClothColourView clothColour;
  TradeUnits units;
  PageScroll scroll;
  bool visibilityOpen = false;   ///< the section of local visibility
  bool visibilityShown = false;  ///< it is open, and on the page that is drawn
};

/// Computed beside the fabric, by workers.
struct InspectorModel {
  const YarnSection* section = nullptr;  ///< of the yarn looked at; null while unknown
  double crimpWarp = 0, crimpWeft = 0;
  double thickness_mm = 0, arealMass_g_m2 = 0;
  bool measured = false;           ///< the four above are known
  const Floats* floats = nullptr;  ///< null while unknown, like the two below
  const Binding* binding = nullptr;
  const std::vector<std::string>* warnings = nullptr;  ///< in plain words
  ShownYarns yarns;
  ImTextureID closeUp{};                      ///< of the yarn looked at
  std::optional<StandardIlluminant> ownLamp;  ///< of a cloth that is judged by another
  bool inches = false;                        ///< setts and lengths to the inch; else to the centimetre
  ClothColourModel clothColour;               ///< of the part that takes the dye
  VisibilityModel visibility;                 ///< of the yarn looked at
};

struct InspectorResult {
  std::optional<Fabric> fabric;
  std::optional<Camera> camera;  ///< looking around is no edit of the cloth
  std::optional<Command> command;
};

/// Yarn, fibre, cloth and scene. Fields hold the ranges of the file format.
InspectorResult inspector(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view);

/// The fibre that the page of fibres shows: of the yarn looked at the only one, or one of its blend.
int shownFibre(const Fabric& fabric, const InspectorView& view);

// The pages; each returns the fabric after an edit.
std::optional<Fabric> yarnPage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view);
std::optional<Fabric> fibrePage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view);
std::optional<Fabric> clothPage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view);
InspectorResult scenePage(Ui& ui, const Fabric& fabric, const InspectorModel& model);

/// A swatch for each yarn; a click selects.
void yarnChooser(Ui& ui, const ShownYarns& yarns, int& yarn, const char* prefix);

/// One small line however long its names and numbers are, so that what stands below keeps its place; what is cut off is
/// read in a tooltip.
void quietLine(Ui& ui, const char* id, const std::string& text);

}  // namespace loomlight
