#pragma once

#include <cstdint>

#include "app/editor/display/display_driver.h"

namespace loomlight {

/// Pictures on the graphics card, in the OpenGL 3.3 context that is current. Throws std::runtime_error where the shader
/// of the display does not compile.
class OpenGlDriver final : public DisplayDriver {
 public:
  OpenGlDriver() = default;
  OpenGlDriver(const OpenGlDriver&) = delete;  // its pictures count their changes in it
  OpenGlDriver& operator=(const OpenGlDriver&) = delete;

  std::unique_ptr<PictureTexture> makeTexture() override;
  std::unique_ptr<ViewportPicture> makeViewport() override;
  /// How often any of its pictures has come to show something else.
  uint64_t changes() const { return changes_; }

 private:
  uint64_t changes_ = 0;
};

}  // namespace loomlight
