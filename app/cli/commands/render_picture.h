#pragma once

#include <memory>
#include <string>

#include "app/cli/commands/render_command.h"
#include "app/cli/interrupt.h"
#include "render/scene/scene.h"

namespace loomlight {

/// One picture of a command.
struct RenderOrder {
  std::string input;          ///< empty: that of the picture to resume
  std::string output, stats;  ///< stats may be empty
  std::optional<int> frame;   ///< of the command's turn
};

/// What was built for a picture, for the next one to use of it what is the same.
struct ReusableCloth {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Medium> medium;
  MediumCost cost;
};

/// Throws UsageError where the window is not within a picture of so many pixels.
void expectWindowIn(int width, int height, const PixelRect& window);
/// Throws UsageError where `samples` samples from `first` on, counted from 0, are not among those of a pixel.
void expectSamplesAmong(int samplesPerPixel, int first, int samples);

/// Renders a picture, or the part of it that the command asks for, and writes it. Exit status: 0, or 130 where it was
/// stopped. Throws InputError and UsageError.
int renderPicture(const RenderCommand& command, const RenderOrder& job, const Interrupt& interrupt,
                  ReusableCloth& built);

}  // namespace loomlight
