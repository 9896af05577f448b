#include "app/export/picture_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "app/export/picture.h"
#include "core/base/checksum.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/json/json_text.h"
#include "render/film/image.h"

// How it works. What a part is goes into the file's metadata as JSON: its origin, and its boxes of samples as six
// numbers each. The fabric is there anyway. Names of meshes and environments may differ from machine to machine, so
// parts are compared by digests of what is in these files instead.

namespace loomlight {
namespace {

using nlohmann::json;

constexpr const char* kPartKey = "loomlight.part";
constexpr size_t kMaxFileBytes = size_t{1} << 32;

constexpr std::array<std::pair<const char*, std::string SampleOrigin::*>, 6> kOriginKeys{
    {{"program", &SampleOrigin::program},
     {"fibres", &SampleOrigin::fibres},
     {"mesh", &SampleOrigin::mesh},
     {"environment", &SampleOrigin::environment},
     {"lamp", &SampleOrigin::lamp},
     {"processor", &SampleOrigin::processor}}};

std::string digestOf(const std::string& file) {
  return fmt::format("{:016x}", checksum(readFile(file, kMaxFileBytes)));
}

std::string partText(const PartInfo& info) {
  nlohmann::ordered_json text;
  for (const auto& [key, member] : kOriginKeys)
    if (!(info.origin.*member).empty()) text[key] = info.origin.*member;
  for (const SampleBox& box : info.boxes)
    text["boxes"].push_back({box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z});
  return jsonText(text);
}

/// A text that messages may show; empty where there is none.
std::string lineOf(const json& texts, const char* key) {
  std::string line = texts.value(key, "");
  const auto shows = [](char c) { return c >= 0x20 && c < 0x7F; };
  if (!std::all_of(line.begin(), line.end(), shows)) throw std::out_of_range("a text that no terminal shows");
  return line;
}

std::vector<SampleBox> boxesOf(const json& lists, const RenderSettings& settings) {
  std::vector<SampleBox> boxes;
  const glm::ivec3 most(settings.width, settings.height, static_cast<int>(Film::maxSamples));
  if (lists.size() > kMaxSampleBoxes) throw std::out_of_range("too many boxes");
  for (const json& list : lists) {
    const auto n = list.get<std::array<int, 6>>();
    const SampleBox box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    const bool sound = glm::all(glm::lessThanEqual(glm::ivec3(0), box.low)) &&
                       glm::all(glm::lessThan(box.low, box.high)) && glm::all(glm::lessThanEqual(box.high, most));
    if (!sound) throw std::out_of_range("a box beyond the picture");
    boxes.push_back(box);
  }
  if (boxes.empty() || findOverlap(boxes)) throw std::out_of_range("no boxes, or some that overlap");
  return boxes;
}

PartInfo infoOf(const std::map<std::string, std::string>& texts, const std::string& file) {
  PartInfo info;
  info.fabric = fabricInTexts(texts, file);
  const RenderSettings& settings = info.fabric.render;
  const auto found = texts.find(kPartKey);
  if (found == texts.end()) {
    info.boxes = {SampleBox::of({0, 0, settings.width, settings.height}, 0, settings.samplesPerPixel)};
    return info;
  }
  try {
    const json text = json::parse(found->second);
    for (const auto& [key, member] : kOriginKeys) info.origin.*member = lineOf(text, key);
    info.boxes = boxesOf(text.at("boxes"), settings);
  } catch (const std::exception&) {
    throw InputError(
        fmt::format("{}: expected the metadata '{}' as Loomlight writes it, got something else", file, kPartKey));
  }
  return info;
}

/// `film` is of the window of the boxes.
Image imageOf(const Film& film, const PartInfo& info, const std::string& file) {
  Image image = film.toImage(true);
  image.metadata.merge(exrTexts(film, info.fabric, file));
  image.metadata[kPartKey] = partText(info);
  return image;
}

/// Without what may differ between parts of a picture: how many samples it is to have, and where its files lie.
json comparable(Fabric fabric) {
  fabric.render.samplesPerPixel = 1;
  fabric.drape.file = fabric.light.file = fabric.light.illuminantFile = "";
  return json::parse(fabricToJson(fabric));
}

[[noreturn]] void failOf(const char* what, const std::string& wanted, const std::string& wantedFile,
                         const std::string& other, const std::string& otherFile) {
  const auto orNone = [](const std::string& text) { return text.empty() ? "none" : text; };
  throw InputError(fmt::format("{}: expected samples of the same {} as {}, but here they are of {} and there of {}",
                               otherFile, what, wantedFile, orNone(other), orNone(wanted)));
}

}  // namespace

SampleOrigin originOf(const Fabric& fabric, const std::string& program, const std::string& fibres) {
  SampleOrigin origin{program, fibres, "", "", "", ""};
  if (fabric.drape.kind == DrapeKind::mesh) origin.mesh = digestOf(fabric.drape.file);
  if (fabric.light.kind == LightKind::environment) origin.environment = digestOf(fabric.light.file);
  if (fabric.light.illuminant == StandardIlluminant::file) origin.lamp = digestOf(fabric.light.illuminantFile);
  return origin;
}

std::string withKind(const std::string& before, const std::string& added) {
  if (before.empty() || before == added) return added;
  return added.empty() ? before : kSeveralKinds;
}

void writePart(const std::string& file, const Film& film, const PartInfo& info) {
  const PixelRect window = windowAround(info.boxes);
  if (window == PixelRect{0, 0, film.width(), film.height()}) {
    writeExr(file, imageOf(film, info, file));
    return;
  }
  Image image = imageOf(film.cropped(window), info, file);
  image.left = window.x;
  image.top = window.y;
  image.wholeWidth = film.width();
  image.wholeHeight = film.height();
  writeExr(file, image);
}

PartInfo readPartInfo(const std::string& file) {
  return infoOf(readExrTexts(file), file);
}

PicturePart readPart(const std::string& file) {
  const Image image = readExr(file);
  PartInfo info = infoOf(image.metadata, file);
  const PixelRect window = windowAround(info.boxes);
  if (PixelRect{image.left, image.top, image.width, image.height} != window)
    throw InputError(fmt::format("{}: expected the pixels {},{},{}x{} as its metadata says, got {},{},{}x{}", file,
                                 window.x, window.y, window.width, window.height, image.left, image.top, image.width,
                                 image.height));
  return {std::move(info), window, Film::fromImage(image, file)};
}

void expectSameFabric(const Fabric& wanted, const std::string& wantedFile, const Fabric& other,
                      const std::string& otherFile) {
  const json differences = json::diff(comparable(wanted), comparable(other));
  if (differences.empty()) return;
  throw InputError(
      fmt::format("{}: expected a picture of the same fabric with the same settings as {}, but they differ at {}",
                  otherFile, wantedFile, differences[0].at("path").get<std::string>()));
}

void expectSameOrigin(const SampleOrigin& wanted, const std::string& wantedFile, const SampleOrigin& other,
                      const std::string& otherFile) {
  const auto expectSame = [&](const std::string& a, const std::string& b, const char* what) {
    if (a != b) failOf(what, a, wantedFile, b, otherFile);
  };
  expectSame(wanted.program, other.program, "program");
  expectSame(wanted.fibres, other.fibres, "fibres");
  expectSame(wanted.mesh, other.mesh, "mesh");
  expectSame(wanted.environment, other.environment, "environment");
  expectSame(wanted.lamp, other.lamp, "spectrum of the lamps");
}

void expectSameProcessor(const SampleOrigin& wanted, const std::string& wantedFile, const SampleOrigin& other,
                         const std::string& otherFile) {
  if (other.processor == kSeveralKinds)
    throw InputError(fmt::format(
        "{}: expected samples of one kind of processor, but one kind began them and another went on", otherFile));
  const bool anyWillDo = wanted.processor.empty() || other.processor.empty();
  if (!anyWillDo && wanted.processor != other.processor)
    failOf("kind of processor", wanted.processor, wantedFile, other.processor, otherFile);
}

}  // namespace loomlight
