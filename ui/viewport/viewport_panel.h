#pragma once

#include <optional>
#include <string>

#include "ui/viewport/camera_moves.h"
#include "ui/viewport/inset_overlay.h"
#include "ui/widgets/crossing_index.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// Of a texture what lies to the left of and above `end`, in parts of its width and height.
struct PartOfTexture {
  ImTextureID texture{};  ///< of the display; null: none yet
  ImVec2 end{1, 1};
};

/// What the panel shows; put together by the editor each frame.
struct ViewportModel {
  PartOfTexture picture;
  /// Pixels that the picture takes, in the middle of the panel: as many as it asked for, unless it was of another size
  /// when that was traced.
  ImVec2 pictureSize;
  std::optional<CrossingIndex> under;  ///< crossing under the mouse
  std::string underYarn;               ///< name of the yarn seen there
  bool denoised = false;               ///< the picture is; the panel says so
  bool proofed = false;                ///< likewise: shown as it prints
  bool warned = false;                 ///< likewise: colours that are cut off are marked
  bool plain = false;                  ///< likewise: no curve of tone, and no exposure but 0
  bool divided = false;                ///< among the lamps of the booth
  bool building = false;
  double buildProgress = 1;
  std::string flat;                ///< what of flat cloth is looked at in the drape's place; empty: the drape
  std::string error;               ///< why the newest fabric cannot be shown; empty if it can
  std::optional<MeshExtent> mesh;  ///< of a mesh drape, once it is known
  InsetModel inset;
};

constexpr double kMostExposure_stops = 8;  ///< up, and down

/// How the picture is looked at; kept between frames, no part of the fabric.
struct ViewportView {
  double exposure_stops = 0;
  bool filmic = true;                  ///< what is bright is bent to fit; false: the plain tone
  bool denoised = false;               ///< the display takes noise from the picture
  bool booth = false;                  ///< its middle is seen under all lamps of the booth, side by side
  bool fitWanted = false;              ///< frame the whole cloth at the next frame
  int width = 0, height = 0;           ///< pixels that the picture should have
  std::optional<ImVec2> pointer;       ///< mouse over the picture, 0..1 from the top left
  std::vector<std::string> yarnNames;  ///< what yarns are called, set before each frame
  enum class Drag { none, orbit, pan };
  Drag drag = Drag::none;
  InsetView inset;

  /// What is seen under the lamps of a booth is there to be judged, and always plain.
  bool isForJudging(const Light& light) const { return booth || light.kind == LightKind::booth; }
  bool isPlain(const Light& light) const { return !filmic || isForJudging(light); }
};

struct ViewportEdit {
  std::optional<Camera> camera;  ///< looking around is no edit of the cloth
  std::optional<Fabric> fabric;
  std::optional<ImVec2> picked;  ///< a click on the picture, 0..1 from the top left
  InsetEdit inset;
};

/// The cloth: orbit, pan, zoom, exposure, quick choices of light and drape, and the reference inset.
ViewportEdit viewportPanel(Ui& ui, const Fabric& fabric, const ViewportModel& model, ViewportView& view);

}  // namespace loomlight
