#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/live/worker.h"
#include "render/colour/icc_profile.h"
#include "render/colour/soft_proof.h"
#include "ui/dialogs/display_colours.h"

namespace loomlight {

/// The colour profiles by which the window and proofs are shown. They are read on a thread of its own; until then, and
/// where one cannot be read, colours stay as they were.
class ProfileController {
 public:
  /// May take its time, on a thread of its own, and throw.
  using ReadFile = std::function<IccProfile(const std::string& file)>;
  /// `wake` is called when one has been read.
  ProfileController(DisplayColours colours, const std::function<void()>& wake, const ReadFile& read = readIccProfile);

  /// Begins to read those that were chosen before. `system`: what the window system says of its display; may be empty.
  void start(std::string system);
  /// Uses a profile as what it is: of a display from now on, of a printer with its proof on.
  void open(const std::string& file);
  /// Takes what has been read. Why a profile cannot be used; once.
  std::optional<std::string> follow();

  DisplayColours& colours() { return colours_; }
  const DisplayColours& colours() const { return colours_; }
  ProfileNames names() const;
  bool knowsPrinter() const { return printer_.cube != nullptr; }
  /// Through which the window is shown; null: the display is sRGB.
  std::shared_ptr<const ColourCube> displayCube() const;
  /// Of the picture, as it is wanted now.
  SoftProof proof() const;

 private:
  /// A file, or bytes that the window system has in its place.
  struct Source {
    std::string file, bytes;
  };
  struct Profile {
    std::string name;
    std::shared_ptr<const ColourCube> cube;
  };
  struct Read {
    Source source;
    IccProfile::Device device = IccProfile::Device::display;
    Profile profile;
    std::string problem;
  };
  static Worker<Source, Read> worker(const std::function<void()>& wake, const ReadFile& read);
  static Read cubeOf(const Source& source, const IccProfile& profile);
  void use(Read read, bool wanted);

  DisplayColours colours_;
  Profile system_, display_, printer_;
  /// Each its own: neither a source that hangs nor one that is read sooner stands in another's way.
  Worker<Source, Read> keptSystem_, keptDisplay_, keptPrinter_, chosen_;
};

}  // namespace loomlight
