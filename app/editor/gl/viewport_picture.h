#pragma once

#include <imgui.h>

#include <optional>
#include <span>

#include "render/colour/tone.h"
#include "render/film/film.h"
#include "ui/widgets/crossing_index.h"

namespace loomlight {

/// A picture of light on the graphics card, and its conversion to the display: light comes in linear, exposure and tone
/// are a shader's uniforms. All of it in the thread of the window.
class ViewportPicture {
 public:
  ViewportPicture();
  ~ViewportPicture();
  ViewportPicture(const ViewportPicture&) = delete;
  ViewportPicture& operator=(const ViewportPicture&) = delete;

  /// Linear, premultiplied by alpha; row by row from the top left. `hits`: the crossings to be outlined; may be empty.
  void upload(int width, int height, std::span<const glm::vec4> rgba, std::span<const Film::Hit> hits);

  struct Outline {
    CrossingIndex crossing;  ///< of the repeat; every repetition is outlined
    int ends = 1, picks = 1;
    ImVec4 colour;
  };
  /// Draws it into a texture of the display's pixels; null before the first upload.
  ImTextureID display(int width, int height, const Tone& tone, const std::optional<Outline>& outline);

 private:
  void resizeTarget(int width, int height);

  unsigned program_ = 0, vertexArray_ = 0, picture_ = 0, crossings_ = 0, target_ = 0, framebuffer_ = 0;
  int targetWidth_ = 0, targetHeight_ = 0;
  bool filled_ = false;
};

}  // namespace loomlight
