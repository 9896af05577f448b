#pragma once

#include <imgui.h>

#include <bitset>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/editor/display/display_driver.h"
#include "app/editor/model/flat_view.h"
#include "app/editor/services/fabric_stats.h"
#include "app/live/live_renderer.h"
#include "app/live/visibility_worker.h"
#include "ui/inspector/visibility_section.h"
#include "ui/viewport/viewport_panel.h"

namespace loomlight {

/// What of a fabric is looked at.
struct ViewState {
  std::shared_ptr<const Fabric> fabric;  ///< null before the first frame
  int width = 0, height = 0;             ///< pixels of the picture
  bool denoised = false;
  uint32_t rest = kUsualRest;                 ///< samples a pixel at which the picture rests
  bool booth = false;                         ///< divided among the lamps of the booth
  std::optional<InsetRequest> inset;          ///< null: closed
  int yarn = 0;                               ///< whose section and visibility are shown
  std::optional<FlatSight> flat;              ///< null: as it is draped
  bool back = false;                          ///< the cloth is seen from behind
  double longFloat_mm = kUsualFloatLimit_mm;  ///< beyond which floats are listed
  bool visibilityShown = false;               ///< on the screen, whether or not the picture needs it
};

/// The workers that make what is seen of the fabric: its picture, its fibres in the inset, what is worth knowing of
/// it, a yarn's visibility. They are asked when the state changes; the newest that they have brought is at hand here,
/// in the driver's textures where it is a picture. All of it in the thread of the window; no call waits.
class ViewService {
 public:
  /// `wake` is called from the workers. `threads`: for tracing; 0: all that the machine has.
  ViewService(DisplayDriver& driver, const std::function<void()>& wake, int threads);

  /// Takes what has come. Returns whether the picture is another one.
  bool take(bool showsDifference);
  void follow(const ViewState& state);
  /// What may need the cores more than the picture that is looked at.
  enum class Rival { snapshot, tile, handover, sheet, presets, colourways, colourDifference, count };
  /// Stops tracing while any of them does; the picture stays.
  void pause(Rival rival, bool paused) {
    rivals_.set(static_cast<size_t>(rival), paused);
    renderer_.pause(rivals_.any());
  }

  const std::shared_ptr<const Frame>& frame() const { return frame_; }  ///< the one shown; null before the first
  const InsetFrame* insetFrame() const { return insetFrame_.get(); }
  LiveStatus status() const { return renderer_.status(); }
  uint64_t generation() const { return generation_; }  ///< that was asked for last
  std::shared_ptr<const FabricStats> stats() const { return stats_.newest(); }
  std::string insightProblem() const { return stats_.problem(); }
  VisibilityWorker::Status visibilityStatus() const { return visibility_.status(); }
  const BakedVisibility* visibility() const { return shownVisibility_.get(); }

  /// Another cloth has been opened: until there is a picture of it at full resolution, or that takes long, the
  /// processors are for nothing else.
  void open() { opened_ = Clock::now(); }
  bool isOpening() const;

  /// Whether the picture is of this very fabric, looked at so, and no first look.
  bool shows(const std::shared_ptr<const Fabric>& fabric, const ClothView& view) const;
  /// Of the picture, at fractions of its window's width and height from the top left.
  std::optional<Film::Hit> hitAt(ImVec2 fraction) const;
  /// So that its window takes `size` pixels of the display.
  PartOfTexture picture(ImVec2 size, const Tone& tone, const SoftProof& proof,
                        std::optional<ViewportPicture::Outline> outline);
  /// The fabric as it is looked at now.
  std::shared_ptr<const Fabric> asSeen(const std::shared_ptr<const Fabric>& fabric) const;
  /// Of the inset, in pixels of its own; null while there is nothing to show.
  ImTextureID insetPicture(const Tone& tone, const SoftProof& proof);
  VisibilityModel visibilityModel(int yarn) const;

 private:
  using Clock = std::chrono::steady_clock;
  void upload(const Frame& newest);
  void takeInset(bool showsDifference);
  void followPicture(const ViewState& state);
  /// The newest cloth where it is the one that is looked at; else null.
  std::shared_ptr<const Scene> builtAsSeen() const;

  FabricStatsWorker stats_;
  VisibilityWorker visibility_;
  LiveRenderer renderer_;
  std::bitset<static_cast<size_t>(Rival::count)> rivals_;  ///< that need the cores now
  ViewState state_;                                        ///< what was asked for last
  std::shared_ptr<const Fabric> seen_;                     ///< its fabric as it is looked at
  uint64_t generation_ = 0;                                ///< of the picture
  std::optional<Clock::time_point> opened_{Clock::now()};  ///< null once it is seen
  std::shared_ptr<const BakedVisibility> usedVisibility_;  ///< the tables that the renderer has

  std::shared_ptr<const Scene> built_;  ///< the newest cloth
  std::shared_ptr<const Frame> frame_;
  std::shared_ptr<const InsetFrame> insetFrame_;
  std::shared_ptr<const BakedVisibility> shownVisibility_;
  std::unique_ptr<ViewportPicture> picture_, insetPicture_;
  std::unique_ptr<PictureTexture> visibilityPicture_;
  const void* insetUpload_ = nullptr;  ///< what of the inset frame is in its picture
  bool insetIsDifference_ = false;
};

}  // namespace loomlight
