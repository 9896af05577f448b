#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <span>

#include "render/colour/soft_proof.h"
#include "render/colour/tone.h"
#include "render/film/film.h"
#include "render/film/image.h"
#include "render/film/pixel_rect.h"
#include "ui/widgets/crossing_index.h"

namespace loomlight {

/// A small picture that Dear ImGui can show as it is.
class PictureTexture {
 public:
  virtual ~PictureTexture() = default;
  virtual void upload(const Pixels8& pixels) = 0;  ///< three channels
  virtual ImTextureID id() const = 0;              ///< null before the first upload
};

/// A picture of light, and its conversion to the display: light comes in linear, exposure and tone are applied when it
/// is shown.
class ViewportPicture {
 public:
  virtual ~ViewportPicture() = default;

  /// Linear, premultiplied by alpha; row by row from the top left. `hits`: the crossings to be outlined; may be empty.
  void upload(int width, int height, std::span<const glm::vec4> rgba, std::span<const Film::Hit> hits) {
    const PixelRect whole{0, 0, width, height};
    uploadParts(width, height, rgba, hits, whole, whole);
  }
  /// Uploads only the parts that have changed since the upload before, which had the same size: pixels outside them are
  /// not read.
  virtual void uploadParts(int width, int height, std::span<const glm::vec4> rgba, std::span<const Film::Hit> hits,
                           const PixelRect& newLight, const PixelRect& newHits) = 0;

  struct Outline {
    CrossingIndex crossing;  ///< of the repeat; every repetition is outlined
    int ends = 1, picks = 1;
    Rgb colour{0.0f};  ///< sRGB
    friend bool operator==(const Outline&, const Outline&) = default;
  };
  /// Draws it into a texture of the display's pixels; null before the first upload.
  virtual ImTextureID display(int width, int height, const Tone& tone, const SoftProof& proof,
                              const std::optional<Outline>& outline) = 0;
};

/// Keeps the pictures that the editor shows, so that the editor itself knows no graphics library: OpenGL's memory in
/// the window, plain memory where tests run the editor without one. All of it in the thread that draws. Outlives its
/// pictures.
class DisplayDriver {
 public:
  virtual ~DisplayDriver() = default;
  virtual std::unique_ptr<PictureTexture> makeTexture() = 0;
  virtual std::unique_ptr<ViewportPicture> makeViewport() = 0;
};

}  // namespace loomlight
