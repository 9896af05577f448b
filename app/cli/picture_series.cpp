#include "app/cli/picture_series.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "app/cli/option_values.h"
#include "app/cli/usage_error.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text_encoding.h"

namespace loomlight {
namespace {

constexpr int kMostFrames = 99999;
constexpr size_t kMostListBytes = 16'000'000;
const std::string kFabricPlace = "{}";

bool hasDirection(LightKind kind) {
  return kind == LightKind::sky || kind == LightKind::window || kind == LightKind::booth ||
         kind == LightKind::directional || kind == LightKind::environment;
}

/// What stands before and behind the first `separator`; the second is empty where there is none.
std::pair<std::string, std::string> apart(const std::string& text, const std::string& separator) {
  const size_t at = text.find(separator);
  if (at == std::string::npos) return {text, ""};
  return {text.substr(0, at), text.substr(at + separator.size())};
}

}  // namespace

Turntable parseTurntable(const std::string& option, const std::string& text) {
  const auto [what, amounts] = apart(text, ":");
  Turntable turn;
  if (what == "light")
    turn.what = Turntable::What::light;
  else if (what != "camera")
    throw UsageError(
        fmt::format("{}: expected camera or light, such as camera:36 or light:24,90, got '{}'", option, text));
  if (text.find(':') == std::string::npos) return turn;
  const auto [frames, degrees] = apart(amounts, ",");
  turn.frames = static_cast<int>(parseWhole(option + " (frames)", frames, 1, kMostFrames));
  if (amounts.find(',') != std::string::npos) turn.degrees = parseNumber(option + " (degrees)", degrees, -3600, 3600);
  return turn;
}

FrameRange parseFrames(const std::string& option, const std::string& text) {
  const auto [first, last] = apart(text, "..");
  FrameRange range;
  range.first = range.last = static_cast<int>(parseWhole(option, first, 1, kMostFrames));
  if (text.find("..") != std::string::npos)
    range.last = static_cast<int>(parseWhole(option, last, range.first, kMostFrames));
  return range;
}

void expectTurnable(const Turntable& turn, LightKind light) {
  if (turn.what == Turntable::What::light && !hasDirection(light))
    throw UsageError(
        "--turn light: expected a light with a direction: sky, window, booth, directional or ibl; choose one by "
        "--light");
}

Fabric inFrame(Fabric fabric, const Turntable& turn, int frame) {
  expectTurnable(turn, fabric.light.kind);
  if (frame == 1) return fabric;
  double& azimuth_deg = turn.what == Turntable::What::camera ? fabric.camera.azimuth_deg : fabric.light.azimuth_deg;
  azimuth_deg = std::remainder(azimuth_deg + (frame - 1) * turn.degrees / turn.frames, 360.0);
  return fabric;
}

std::string nameInSeries(const std::string& pattern, const std::string& input, std::optional<int> frame) {
  std::string name = pattern;
  if (const size_t last = name.rfind('#'); frame && last != std::string::npos) {
    const size_t before = name.find_last_not_of('#', last);
    const size_t begin = before == std::string::npos ? 0 : before + 1;
    name.replace(begin, last + 1 - begin, fmt::format("{:0{}}", *frame, last + 1 - begin));
  }
  const std::string stem = std::filesystem::path(input).stem().string();
  for (size_t at = name.find(kFabricPlace); at != std::string::npos; at = name.find(kFabricPlace, at + stem.size()))
    name.replace(at, kFabricPlace.size(), stem);
  return name;
}

std::vector<std::string> namesInList(const std::string& file) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const std::string bytes = readFile(file, kMostListBytes);
  const DecodedText decoded = decodeText(bytes, file);
  // Names of files may be of no encoding, and are taken as they are; but UTF-16 has to be decoded, and a mark before
  // UTF-8 is no part of the first name.
  const bool isMarked = bytes.starts_with(kMark);
  std::istringstream lines(decoded.encoding == TextEncoding::utf16 ? decoded.text
                                                                   : bytes.substr(isMarked ? kMark.size() : 0));
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty() && line.front() != '#') names.push_back((folder / line).string());
  }
  if (names.empty()) throw InputError(fmt::format("{}: expected the name of a fabric in each line, got none", file));
  return names;
}

}  // namespace loomlight
