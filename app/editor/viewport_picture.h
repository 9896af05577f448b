#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "app/workers/live_renderer.h"
#include "render/film/tone.h"
#include "ui/crossing_index.h"

namespace loomlight {

/// The newest frame on the graphics card, and its conversion to the display: light comes in linear, exposure and tone
/// are a shader's uniforms. All of it in the thread of the window.
class ViewportPicture {
 public:
  ViewportPicture();
  ~ViewportPicture();
  ViewportPicture(const ViewportPicture&) = delete;
  ViewportPicture& operator=(const ViewportPicture&) = delete;

  void upload(const Frame& frame);

  struct Outline {
    CrossingIndex crossing;  ///< of the repeat; every repetition is outlined
    int ends = 1, picks = 1;
    ImVec4 colour;
  };
  /// Draws the frame into a texture of the display's pixels; null before the first upload.
  ImTextureID display(int width, int height, const Tone& tone, const std::optional<Outline>& outline);

 private:
  void resizeTarget(int width, int height);

  unsigned program_ = 0, vertexArray_ = 0, picture_ = 0, crossings_ = 0, target_ = 0, framebuffer_ = 0;
  int targetWidth_ = 0, targetHeight_ = 0;
  bool filled_ = false;
};

}  // namespace loomlight
