#pragma once

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/gl/display_pass.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

struct GLFWmonitor;
struct GLFWwindow;

namespace loomlight {

/// The window, its OpenGL 3.3 context and Dear ImGui, from construction to destruction. One at a time; used by the
/// thread that made it, but for wake().
class Window {
 public:
  /// `scale` 0: from the monitor. Throws InputError when there is no display or no OpenGL 3.3.
  Window(const std::string& title, int width, int height, float scale);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  float scale() const { return scale_; }
  /// Of the display that the window is on, as it says; 96 to the inch where it does not.
  double pixels_per_mm();
  /// Makes the interface larger or smaller than the monitor asks for. Not within a frame.
  void setInterfaceSize(float factor);
  const Fonts& fonts() const { return fonts_; }
  void setTheme(const Theme& theme);
  void setTitle(const std::string& title);
  /// All that is drawn is sRGB; `cube` brings it to the display's colours. Null: the display is sRGB. Not within a
  /// frame.
  void setDisplayCube(std::shared_ptr<const ColourCube> cube);

  /// Sleeps until there is input, wake(), or the time is over; 0 does not sleep. True when there was input.
  bool waitForEvents(double seconds);
  /// How many events of mouse and keyboard have come.
  uint64_t inputCount() const { return inputCount_; }
  static void wake();  ///< from any thread

  void beginFrame();
  /// Draws the frame, unless it looks like the one that is on the screen: a few frames follow every event, of which
  /// most look alike, and without a graphics card to draw them all took a third of the processor.
  /// `pictureChanges`: how often the pictures that it shows have changed. Returns whether it was drawn; only then has
  /// it waited for the display.
  bool endFrame(const Theme& theme, uint64_t pictureChanges);
  /// The next frame is drawn whatever it looks like.
  void drawAnew() { onScreen_.reset(); }
  /// How many frames have been drawn.
  uint64_t drawnCount() const { return drawnCount_; }

  bool closeWanted() const;
  void refuseClose();
  void setFullScreen(bool on);
  ImVec2 sizeInWindow() const;  ///< as it is to be opened again: not that of full screen
  std::vector<std::string> takeDroppedFiles();

 private:
  /// That the middle of the window is on, or the first where it is on none; null without any.
  GLFWmonitor* monitor() const;
  double askDisplay_per_mm() const;
  float wantedScale() const;
  void followScale();
  void noticeInput();

  GLFWwindow* window_ = nullptr;
  float scale_ = 1, givenScale_ = 0, interfaceSize_ = 1;
  bool fullScreen_ = false;
  bool inputSeen_ = false;
  uint64_t inputCount_ = 0, drawnCount_ = 0;
  std::optional<uint64_t> onScreen_;     ///< digest of the frame; null where the screen has lost it
  std::optional<double> pixels_per_mm_;  ///< of the display; null: the window has been placed since it was asked
  int windowedX_ = 0, windowedY_ = 0, windowedWidth_ = 0, windowedHeight_ = 0;
  Theme theme_ = Theme::dark();
  Fonts fonts_;
  std::unique_ptr<DisplayPass> displayPass_ = std::make_unique<DisplayPass>();  ///< ends before its context
  std::vector<std::string> dropped_;
  std::string shownTitle_;
};

}  // namespace loomlight
