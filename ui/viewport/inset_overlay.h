#pragma once

#include <string>
#include <vector>

#include "ui/viewport/inset_view.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// What the inset shows; put together by the editor each frame.
struct InsetModel {
  ImTextureID picture{};  ///< of `window`; null: the cloth below is seen through it
  InsetRect window;       ///< may reach a little beyond the inset
  std::string caption;    ///< what is seen: "fibres, 12 samples"
  bool laying = false;
  double progress = 0;        ///< of laying, 0..1
  std::string trouble;        ///< why there is nothing to be seen; empty if there is or soon will be
  std::string remedy;         ///< what can be done to the cloth about it, as a button says it; empty: nothing
  bool limitMatters = false;  ///< more would fit under another limit
  std::vector<ImVec4> scale;  ///< colours of the difference, from none
  std::string scaleEnd;       ///< what the last one stands for
};

struct InsetEdit {
  bool remedy = false;
  bool changeLimit = false;
};

/// The frame, the bar that moves it, and what is seen in it, over a viewport whose top left corner is `origin`.
InsetEdit insetOverlay(Ui& ui, const InsetModel& model, InsetView& view, ImVec2 origin, int viewportWidth,
                       int viewportHeight);

/// The button of the strip that opens and closes the inset.
void insetButton(Ui& ui, InsetView& view, float size);

}  // namespace loomlight
