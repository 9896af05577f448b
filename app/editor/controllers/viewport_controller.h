#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/model/settings.h"
#include "app/editor/services/view_service.h"
#include "core/base/units.h"
#include "core/fabric/model/booth_lamps.h"
#include "ui/flat_menu.h"
#include "ui/viewport/viewport_panel.h"

namespace loomlight {

/// The panel of the picture, and the workers that make what is seen in it.
class ViewportController {
 public:
  ViewportController(DisplayDriver& driver, const std::function<void()>& wake, int threads)
      : service_(driver, wake, threads) {}

  /// What the panel asks for in a frame.
  struct Edit {
    std::optional<Fabric> fabric;
    std::optional<Camera> camera;  ///< looking around is no edit of the cloth
    std::optional<int> yarn;       ///< that was clicked at
    bool preferences = false;      ///< are asked for: the inset needs more memory
    bool orbited = false;          ///< the camera has gone round the cloth in this frame
  };
  /// `hovered`: the crossing under the mouse in the draft, which is outlined in the picture. `proof`: how the picture
  /// is shown, and the inset in it.
  Edit draw(Ui& ui, const std::shared_ptr<const Fabric>& fabric, const std::optional<CrossingIndex>& hovered,
            const SoftProof& proof, double fibreMemory_GB);

  /// Takes what the workers have brought. Returns whether the picture is another one.
  bool take() { return service_.take(view_.inset.showsDifference); }
  /// Which side of the cloth is looked at, and what on it.
  struct ClothSide {
    bool back = false;                          ///< seen from behind, the draft and the cloth with it
    double longFloat_mm = kUsualFloatLimit_mm;  ///< floats beyond it are listed
  };
  /// Has the workers follow the fabric, and one yarn of it, whose visibility is on the screen or not.
  void follow(const std::shared_ptr<const Fabric>& fabric, int yarn, bool visibilityShown, const ViewLimits& limits,
              const ClothSide& side);
  void tellProbe(WidgetProbe& probe, int yarn);

  void displayIs(double pixels_per_mm) { display_pixels_per_mm_ = pixels_per_mm; }
  /// A camera that shows the cloth as large as it is, straight from above. `rulerFactor`: how much longer a ruler finds
  /// the display's millimetres than the system says.
  Camera atActualSize(const Fabric& fabric, double rulerFactor) const;
  /// Looks at so much flat cloth instead of the drape, straight from above, until another drape is chosen. It is a
  /// view: the fabric stays as it is.
  void layFlat(const Fabric& fabric, const FlatCloth& cloth);
  void leaveFlat() { flat_.reset(); }
  /// How the cloth is looked at; null: as it is draped.
  std::optional<FlatView> flatView() const { return flat_ ? std::optional(flat_->view) : std::nullopt; }
  /// Looks at a fabric in such a way again.
  void lookAs(const std::optional<FlatView>& flat, const Fabric& fabric);
  /// Moves the camera that looks at flat cloth; false where there is none.
  bool lookAtFlat(const Camera& camera);
  /// The middle of the view under all lamps of the booth. It is a view; the lens closes.
  void showBooth(bool wanted) {
    view_.booth = wanted;
    if (wanted) view_.inset.close();
  }
  FlatMenuModel flatMenu() const { return {flatRepeats_, flatSide_cm_, flat_.has_value()}; }
  ViewportView& view() { return view_; }
  const ViewportView& view() const { return view_; }
  ViewService& service() { return service_; }
  const ViewService& service() const { return service_; }
  /// How cloth in this light is shown.
  Tone tone(const Light& light) const;
  /// The crossing of the cloth under the mouse.
  const std::optional<CrossingIndex>& underPointer() const { return underPointer_; }

 private:
  struct Flat {
    FlatView view;
    Drape instead;        ///< of which drape
    glm::dvec2 asked_mm;  ///< so large is what was asked for, of the fabric as it is
  };
  double aspect() const { return static_cast<double>(std::max(view_.width, 1)) / std::max(view_.height, 1); }
  std::optional<FlatSight> flatSight() const { return flat_ ? std::optional(flat_->view.sight) : std::nullopt; }
  /// What was edited of the cloth as it lies flat becomes an edit of the cloth on its drape, or nothing.
  std::optional<Fabric> onItsDrape(Fabric edited, const Fabric& fabric);
  InsetModel insetModelFor(const InsetStatus& status, const Fabric& fabric, const SoftProof& proof,
                           double fibreMemory_GB);
  void lookUnderPointer();

  ViewportView view_;
  ViewService service_;
  double display_pixels_per_mm_ = 96 / kMmPerInch;
  std::optional<Flat> flat_;
  int flatRepeats_ = 4;  ///< that were looked at last
  double flatSide_cm_ = 10;
  std::optional<CrossingIndex> underPointer_;
  std::string underPointerYarn_;
  // What tests are told:
  std::shared_ptr<const Frame> lightToldOf_;
  std::string shownLight_;
  std::array<std::string, kBoothLamps.size()> boothLight_;
};

}  // namespace loomlight
