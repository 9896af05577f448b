#pragma once

#include <imgui.h>

#include "render/film/image.h"

namespace loomlight {

/// A small picture on the graphics card, for the display as it is. All of it in the thread of the window.
class PictureTexture {
 public:
  PictureTexture() = default;
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  void upload(const Pixels8& pixels);  ///< three channels
  ImTextureID id() const { return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture_)); }

 private:
  unsigned texture_ = 0;
};

}  // namespace loomlight
