#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/fabric_options.h"
#include "app/cli/picture_series.h"
#include "app/cli/progress.h"
#include "core/fabric/wif/wif_fabric.h"
#include "render/colour/tone.h"
#include "render/film/pixel_rect.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// What of a picture is rendered; what is not given is all of it.
struct PartChoice {
  std::optional<int> firstSample;  ///< counted from 0
  std::optional<int> samples;      ///< from that one on; not given: up to the samples per pixel of the whole picture
  std::optional<PixelRect> crop;

  bool isWhole() const { return !firstSample && !samples && !crop; }
};

/// loomlight render FABRIC... -o OUT
struct RenderCommand {
  std::vector<std::string> inputs;  ///< fabrics, or pictures that carry one; may be empty with a list or `resume`
  std::string list;                 ///< a text file with names of more inputs; empty: none
  std::string output;               ///< .exr or .png; a pattern where there are several pictures
  FabricOptions options;
  WifChoices wif;                                         ///< of a draft
  Tone tone;                                              ///< of a .png
  int threads = 0;                                        ///< 0: all
  double memoryLimit_bytes = defaultMemoryLimit_bytes();  ///< of explicit fibres
  FibreExtent fibreExtent = FibreExtent::automatic;
  std::string stats;   ///< file for the figures; empty: none
  std::string resume;  ///< an .exr with sums, to be continued; empty: none
  bool keepSums = false;
  PartChoice part;
  std::optional<Turntable> turn;
  std::optional<FrameRange> frames;  ///< of the turn
  ProgressStyle progress = ProgressStyle::plain;
};

/// Renders, and writes the picture or pictures; one of several that cannot be rendered, be it that an option does not
/// fit its fabric, is told, and those behind it are rendered. Exit status: 0; 1 where one of several failed; 130 where
/// Ctrl-C ended it early (the picture then holds what was rendered). Throws InputError and UsageError.
int run(const RenderCommand& command);

}  // namespace loomlight
