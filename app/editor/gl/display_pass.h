#pragma once

#include <memory>

#include "app/editor/gl/gl_program.h"

namespace loomlight {

/// Brings all that a window shows to the colours of its display, in one place and at the end: what is drawn goes into a
/// picture of its own, in sRGB, and from there through the display's cube onto the screen. Costs a copy of the window;
/// nothing where there is no cube.
class DisplayPass {
 public:
  DisplayPass() = default;
  ~DisplayPass();
  DisplayPass(const DisplayPass&) = delete;
  DisplayPass& operator=(const DisplayPass&) = delete;

  /// Null: the display is sRGB. Returns whether that changes what is shown.
  bool use(std::shared_ptr<const ColourCube> cube);
  /// What is drawn between the two is brought to the display's colours. Pixels of the window.
  void begin(int width, int height);
  void end();

 private:
  void makeOnce();

  std::shared_ptr<const ColourCube> cube_;
  GLuint program_ = 0, vertexArray_ = 0, window_ = 0, cubeTexture_ = 0, framebuffer_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace loomlight
