#include "app/cli/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include "app/cli/usage_error.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/lamp_name.h"

namespace loomlight {
namespace {

constexpr int kLargestSide = 16384;

[[noreturn]] void refuse(const std::string& option, const std::string& expected, const std::string& got) {
  throw UsageError(fmt::format("{}: expected {}, got '{}'", option, expected, got));
}

template <class T>
std::optional<T> wholeText(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t begin = 0;
  for (size_t end = 0; (end = text.find(separator, begin)) != std::string::npos; begin = end + 1)
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

bool knownResolution(int64_t value) {
  return value == 1 || value == 2 || value == 4 || value == 8 || value == 16;
}

template <class Enum>
Enum parseChoice(const std::string& option, const std::string& text) {
  if (const auto choice = choiceFromName<Enum>(text)) return *choice;
  refuse(option, choiceList<Enum>(), text);
}

}  // namespace

int64_t parseWhole(const std::string& option, const std::string& text, int64_t lowest, int64_t highest) {
  const auto value = wholeText<int64_t>(text);
  if (!value || *value < lowest || *value > highest)
    refuse(option, fmt::format("a whole number from {} to {}", lowest, highest), text);
  return *value;
}

uint64_t parseSeed(const std::string& option, const std::string& text) {
  const auto value = wholeText<uint64_t>(text);
  if (!value) refuse(option, fmt::format("a whole number from 0 to {}", std::numeric_limits<uint64_t>::max()), text);
  return *value;
}

double parseNumber(const std::string& option, const std::string& text, double lowest, double highest) {
  const auto value = wholeText<double>(text);
  if (!value || !(*value >= lowest && *value <= highest))
    refuse(option, fmt::format("a number from {} to {}", lowest, highest), text);
  return *value;
}

PictureSize parseSize(const std::string& option, const std::string& text) {
  const auto sides = split(text, 'x');
  const auto width = wholeText<int>(sides[0]);
  const auto height = sides.size() == 2 ? wholeText<int>(sides[1]) : std::nullopt;
  if (!width || !height || *width < 1 || *height < 1 || *width > kLargestSide || *height > kLargestSide)
    refuse(option, fmt::format("WIDTHxHEIGHT, each from 1 to {}, such as 640x480", kLargestSide), text);
  return {*width, *height};
}

PixelChoice parsePixel(const std::string& option, const std::string& text) {
  const auto parts = split(text, ',');
  const auto x = wholeText<int>(parts[0]);
  const auto y = parts.size() == 2 ? wholeText<int>(parts[1]) : std::nullopt;
  if (!x || !y || *x < 0 || *y < 0 || *x >= kLargestSide || *y >= kLargestSide)
    refuse(option, fmt::format("X,Y, each from 0 to {}, such as 320,240", kLargestSide - 1), text);
  return {*x, *y};
}

PixelRect parseCrop(const std::string& option, const std::string& text) {
  const auto parts = split(text, ',');
  const auto x = wholeText<int>(parts[0]);
  const auto y = parts.size() == 3 ? wholeText<int>(parts[1]) : std::nullopt;
  if (!x || !y || *x < 0 || *y < 0 || *x >= kLargestSide || *y >= kLargestSide)
    refuse(option, "X,Y,WIDTHxHEIGHT in pixels from the top left, such as 100,80,320x240", text);
  const PictureSize size = parseSize(option, parts[2]);
  return {*x, *y, size.width, size.height};
}

int parseResolution(const std::string& option, const std::string& text) {
  const auto value = wholeText<int>(text);
  if (!value || !knownResolution(*value)) refuse(option, "1, 2, 4, 8 or 16 voxels per yarn diameter", text);
  return *value;
}

std::vector<int> parseResolutions(const std::string& option, const std::string& text) {
  std::vector<int> resolutions;
  for (const std::string& part : split(text, ',')) resolutions.push_back(parseResolution(option, part));
  return resolutions;
}

Method parseMethod(const std::string& option, const std::string& text) {
  return parseChoice<Method>(option, text);
}

FibreExtent parseFibreExtent(const std::string& option, const std::string& text) {
  return parseChoice<FibreExtent>(option, text);
}

Estimator parseEstimator(const std::string& option, const std::string& text) {
  return parseChoice<Estimator>(option, text);
}

EventLaw parseEventLaw(const std::string& option, const std::string& text) {
  return parseChoice<EventLaw>(option, text);
}

ProgressStyle parseProgress(const std::string& option, const std::string& text) {
  return parseChoice<ProgressStyle>(option, text);
}

bool parseIsFilmic(const std::string& option, const std::string& text) {
  const bool filmic = text == "filmic";
  if (!filmic && text != "plain") refuse(option, "plain or filmic", text);
  return filmic;
}

WifSizeChoice parseWifSizes(const std::string& option, const std::string& text) {
  return parseChoice<WifSizeChoice>(option, text);
}

WifThreadChoice parseWifThreads(const std::string& option, const std::string& text) {
  return parseChoice<WifThreadChoice>(option, text);
}

HalfDomeGrid parseHalfDome(const std::string& option, const std::string& text) {
  constexpr int kMost = 256;
  const auto counts = split(text, 'x');
  const auto azimuths = wholeText<int>(counts[0]);
  const auto inclinations = counts.size() == 2 ? wholeText<int>(counts[1]) : std::nullopt;
  if (!azimuths || !inclinations || *azimuths < 1 || *inclinations < 1 || *azimuths > kMost || *inclinations > kMost)
    refuse(option, fmt::format("AZIMUTHSxINCLINATIONS, each from 1 to {}, such as 64x16", kMost), text);
  return {*azimuths, *inclinations};
}

PieceSize parsePieceSize(const std::string& option, const std::string& text) {
  const auto sides = split(text, 'x');
  if (sides.size() != 2) refuse(option, "METRESxCM, such as 10x150: the length and the width of the piece", text);
  return {parseNumber(option + " (length in m)", sides[0], kPieceLength_m[0], kPieceLength_m[1]),
          parseNumber(option + " (width in cm)", sides[1], kPieceWidth_cm[0], kPieceWidth_cm[1])};
}

ViewChoice parseView(const std::string& option, const std::string& text) {
  if (const auto preset = viewPreset(text)) return *preset;
  const auto parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 3)
    refuse(option, fmt::format("{}, or AZIMUTH,ELEVATION[,DISTANCE] in degrees and mm", viewPresetNames()), text);
  ViewChoice view;
  view.azimuth_deg = parseNumber(option + " (azimuth)", parts[0], -360, 360);
  view.elevation_deg = parseNumber(option + " (elevation)", parts[1], -90, 90);
  if (parts.size() == 3) view.distance_mm = parseNumber(option + " (distance)", parts[2], 0.1, 1e5);
  return view;
}

IlluminantChoice parseIlluminant(const std::string& option, const std::string& text) {
  const std::optional<NamedLamp> lamp = lampFromName(text);
  if (lamp && lamp->illuminant == StandardIlluminant::blackBody) {
    const FieldInfo info = fieldInfo(&Light::temperature_K);
    if (!(lamp->temperature_K >= info.min && lamp->temperature_K <= info.max))
      refuse(option, fmt::format("a black body of {} to {} K", info.min, info.max), text);
    return {lamp->illuminant, lamp->temperature_K, ""};
  }
  if (lamp) return {lamp->illuminant, {}, ""};
  if (text.find('.') == std::string::npos)
    refuse(option, fmt::format("{}, a black body such as 2856K, or a text file", fmt::join(lampNames(), ", ")), text);
  return {StandardIlluminant::file, {}, text};
}

Observer parseObserver(const std::string& option, const std::string& text) {
  if (text != "2" && text != "10") refuse(option, "2 or 10", text);
  return text == "2" ? Observer::degrees2 : Observer::degrees10;
}

DrapeChoice parseDrape(const std::string& option, const std::string& text) {
  const auto kind = choiceFromName<DrapeKind>(text);
  if (kind && *kind != DrapeKind::mesh) return {*kind, ""};
  // A slip such as 'cilinder' must not turn into a complaint about a missing file.
  if (text.find('.') == std::string::npos)
    refuse(option, "flat, cylinder, sphere, folds, cushion, skirt, or a mesh that ends in .obj, .ply or .off", text);
  return {DrapeKind::mesh, text};
}

LightChoice parseLight(const std::string& option, const std::string& text) {
  struct Named {
    std::string_view name;
    LightKind kind;
    bool turns = false;
  };
  static constexpr Named kLights[] = {{"sky", LightKind::sky, true},     {"directional", LightKind::directional, true},
                                      {"overcast", LightKind::overcast}, {"window", LightKind::window},
                                      {"booth", LightKind::booth},       {"dome", LightKind::dome},
                                      {"point", LightKind::headlight},   {"back", LightKind::back},
                                      {"furnace", LightKind::furnace}};
  const size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string detail = colon == std::string::npos ? "" : text.substr(colon + 1);
  LightChoice light;
  if (name == "ibl") {
    light.kind = detail.empty() ? LightKind::sky : LightKind::environment;
    light.file = detail;
    return light;
  }
  const auto named = std::ranges::find(kLights, name, &Named::name);
  if (named == std::end(kLights))
    refuse(option,
           "ibl, ibl:FILE, sky[:AZ,EL], directional[:AZ,EL], overcast, window, booth, dome, point, back or furnace",
           text);
  light.kind = named->kind;
  if (detail.empty()) return light;
  const auto angles = split(detail, ',');
  if (!named->turns || angles.size() != 2)
    refuse(option, named->turns ? name + ":AZIMUTH,ELEVATION in degrees" : name + " alone", text);
  const double lowest = light.kind == LightKind::sky ? 1.0 : -90.0;
  light.angles = {parseNumber(option + " (azimuth)", angles[0], -360, 360),
                  parseNumber(option + " (elevation)", angles[1], lowest, 90)};
  return light;
}

}  // namespace loomlight
