#pragma once

#include <optional>

#include "app/live/pass_scheduler.h"
#include "core/fabric/model/changes.h"

namespace loomlight {

// What the tracer shows until the picture is there (render/display/preview_quality.h), decided by what it has and what
// is wanted alone: no clock, no thread, no pixels. How fine and how long each pass is, and of which picture, says
// pass_scheduler.h.

/// What there is to see when a scene comes that is to be traced.
struct PreviewHave {
  bool sameRequest = false;  ///< the picture under way is of the same fabric and size: this scene only shows it better
  bool sameSize = false;     ///< the viewport is as large as it was
  int divider = 0;           ///< of the last pass that filled the picture under way; 0: none has so far
  std::optional<Changes> sincePicture;  ///< from the picture under way, begun or not; none: there is none
  std::optional<Changes> sinceClear;    ///< from the last picture with detail of its own; none: there was none
};

/// How a picture begins.
struct PreviewStart {
  bool knowsCost = false;  ///< a path takes about as long as in the picture under way
  int reached = 0;         ///< goes on with passes finer than this, and what is shown fades into it; 0: begins anew
  FirstPass first;         ///< where it begins anew
};
PreviewStart previewStart(const PreviewHave& have);

/// How the last clear picture helps one of few samples.
enum class ClearHelp {
  none,
  patched,   ///< all that crossings which were turned have left of it
  reframed,  ///< of another size, stretched to this one
};

/// A picture's size in pixels, and that of the weave that it shows in threads.
struct PreviewSize {
  int width = 0, height = 0;
  int ends = 0, picks = 0;
  bool operator==(const PreviewSize&) const = default;
};

ClearHelp clearHelp(const Changes& sinceClear, const PreviewSize& clear, const PreviewSize& wanted);

/// Whether pixels of an earlier picture of the same size still show the cloth as it is, from elsewhere.
bool isOnlyMoved(const Changes& sinceEarlier);

/// Whether a picture of so many samples is helped by a clear one of so many.
bool wantsHelp(int samples, int clearSamples);

/// A picture in other colours than it was traced in, and how good it is.
struct RecolouredPicture {
  unsigned worth_samples = 0;  ///< with which one that is traced anew is as good for sure
  bool fading = false;         ///< an earlier picture is still to be seen in it, so its own variance says too much
  double variance = 0;         ///< of the luminance, mean over the pixels
};

/// Whether a picture that is traced anew may take its place: it has no more noise.
bool supersedes(unsigned samples, double variance, const RecolouredPicture& recoloured);

}  // namespace loomlight
