#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A series of pictures in which the camera goes about the cloth, or the light does.
struct Turntable {
  enum class What { camera, light };
  What what = What::camera;
  int frames = 36;       ///< of the whole turn, 1..99999
  double degrees = 360;  ///< of the whole turn, against the clock as seen from above; -3600..3600
};

/// The frames of a turn that are wanted, counted from 1; both are among them.
struct FrameRange {
  int first = 1, last = 1;
};

/// camera, light:24, light:24,90. Throws UsageError.
Turntable parseTurntable(const std::string& option, const std::string& text);
/// 7 or 1..36. Throws UsageError.
FrameRange parseFrames(const std::string& option, const std::string& text);

/// Throws UsageError where it is the light that turns, and this one has no direction.
void expectTurnable(const Turntable& turn, LightKind light);

/// The fabric as it is seen in a frame: the first one is the fabric as it is, each other one is a step of degrees /
/// frames further. Throws UsageError where the light has no direction to turn.
Fabric inFrame(Fabric fabric, const Turntable& turn, int frame);

/// The name of a picture of a series: in `pattern`, {} becomes the input's name without folder and ending, and the last
/// run of # the frame's number, with zeros before it where it is shorter than the run. Without a frame, # stay.
std::string nameInSeries(const std::string& pattern, const std::string& input, std::optional<int> frame);

/// The lines of a text file but empty ones and those that begin with #, as names seen from its folder; a file whose
/// name begins with # is ./#name. Throws InputError where the text cannot be read, or names nothing.
std::vector<std::string> namesInList(const std::string& file);

}  // namespace loomlight
