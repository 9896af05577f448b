#include "app/editor/controllers/profile_controller.h"

#include <utility>

#include "ui/words/error_words.h"

namespace loomlight {

ProfileController::ProfileController(DisplayColours colours, const std::function<void()>& wake, const ReadFile& read)
    : colours_(std::move(colours)),
      keptSystem_(worker(wake, read)),
      keptDisplay_(worker(wake, read)),
      keptPrinter_(worker(wake, read)),
      chosen_(worker(wake, read)) {}

Worker<ProfileController::Source, ProfileController::Read> ProfileController::worker(const std::function<void()>& wake,
                                                                                     const ReadFile& read) {
  return {wake,
          [read](const Source& source, const auto&) -> std::optional<Read> {
            return cubeOf(source, source.file.empty() ? iccProfile(source.bytes, words::errors::systemProfile)
                                                      : read(source.file));
          },
          [](const Source& source, const std::string& problem) { return Read{source, {}, {}, problem}; },
          Backlog::hanging};
}

void ProfileController::start(std::string system) {
  if (!system.empty()) keptSystem_.ask({"", std::move(system)});
  if (!colours_.displayFile.empty()) keptDisplay_.ask({colours_.displayFile, ""});
  if (!colours_.printerFile.empty()) keptPrinter_.ask({colours_.printerFile, ""});
}

void ProfileController::open(const std::string& file) {
  chosen_.ask({file, ""});
}

ProfileController::Read ProfileController::cubeOf(const Source& source, const IccProfile& profile) {
  const bool isDisplay = profile.device == IccProfile::Device::display;
  auto cube = std::make_shared<const ColourCube>(isDisplay ? loomlight::displayCube(profile) : proofCube(profile));
  return {source, profile.device, {profile.description, std::move(cube)}, {}};
}

std::optional<std::string> ProfileController::follow() {
  for (Worker<Source, Read>* worker : {&keptSystem_, &keptDisplay_, &keptPrinter_, &chosen_})
    while (auto read = worker->take()) {
      // Nobody chose the system's, which is only not used where it cannot be.
      if (!read->problem.empty() && !read->source.file.empty()) return read->problem;
      if (read->problem.empty()) use(std::move(*read), worker == &chosen_);
    }
  return std::nullopt;
}

/// `wanted`: just now, not in a session before. What was kept of its kind and is still being read comes too late then.
void ProfileController::use(Read read, bool wanted) {
  if (read.source.file.empty()) {
    system_ = std::move(read.profile);
  } else if (read.device == IccProfile::Device::display) {
    display_ = std::move(read.profile);
    colours_.displayFile = read.source.file;
    if (wanted) {
      colours_.source = DisplayColours::Source::file;
      keptDisplay_.forget();
    }
  } else {
    printer_ = std::move(read.profile);
    colours_.printerFile = read.source.file;
    if (wanted) {
      colours_.proofs = true;
      keptPrinter_.forget();
    }
  }
}

ProfileNames ProfileController::names() const {
  return {system_.name, display_.name, printer_.name};
}

std::shared_ptr<const ColourCube> ProfileController::displayCube() const {
  switch (colours_.source) {
    case DisplayColours::Source::system:
      return system_.cube;
    case DisplayColours::Source::file:
      return display_.cube;
    case DisplayColours::Source::srgb:
      break;
  }
  return nullptr;
}

SoftProof ProfileController::proof() const {
  return {colours_.proofs ? printer_.cube : nullptr, colours_.warnsOfGamut};
}

}  // namespace loomlight
