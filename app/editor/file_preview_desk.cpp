#include "app/editor/file_preview_desk.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "app/editor/draft_picture.h"
#include "app/editor/picture_desk.h"
#include "app/workers/file_name.h"
#include "core/fabric/fabric_json.h"
#include "core/fabric/picture_weave.h"
#include "core/fabric/wif_fabric.h"
#include "render/film/tone.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

constexpr int kSide = 448;                         // pixels: sharp at twice the scale
constexpr uintmax_t kMostBytes = 64'000'000;       // of the file
constexpr double kMostDecodedBytes = 250'000'000;  // a small file may hold a large picture

/// Whether a picture takes little enough memory to be looked at; what it takes at most while it is decoded.
bool isLight(const PictureExtent& extent, double bytesPerPixel) {
  return extent.width * static_cast<double>(extent.height) * bytesPerPixel <= kMostDecodedBytes;
}

std::string sizeText(uintmax_t bytes) {
  if (bytes < 1000) return "under 1 kB";
  const double kB = 1e-3 * static_cast<double>(bytes);
  return kB < 1000 ? fmt::format("{:.0f} kB", kB) : fmt::format("{:.1f} MB", 1e-3 * kB);
}

std::string dateText(const std::string& file) {
  struct stat status {};
  std::tm local{};
  if (stat(file.c_str(), &status) != 0 || !localtime_r(&status.st_mtime, &local)) return {};
  return fmt::format(", {:04}-{:02}-{:02} {:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                     local.tm_hour, local.tm_min);
}

Pixels8 small(const Raster& raster) {
  const int longest = std::max(raster.width, raster.height), side = std::min(longest, kSide);
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(int64_t{length} * side / longest)); };
  const Raster reduced = resampled(raster, scaled(raster.width), scaled(raster.height));
  Pixels8 pixels{reduced.width, reduced.height, 3, {}};
  pixels.bytes.reserve(3 * reduced.pixels.size());
  for (const Rgb8& c : reduced.pixels) pixels.bytes.insert(pixels.bytes.end(), c.begin(), c.end());
  return pixels;
}

/// Light as the display shows it, on the grey of the surround where the picture is transparent.
Raster rasterOf(const Image& image) {
  const Image::Channel *const red = image.find("R"), *const green = image.find("G"), *const blue = image.find("B");
  const Image::Channel* const alpha = image.find("A");
  const Image::Channel* const first = red ? red : image.find("Y") ? image.find("Y") : &image.channels.front();
  Raster raster{image.width, image.height, {}};
  raster.pixels.reserve(first->values.size());
  const Tone tone;
  for (size_t i = 0; i < first->values.size(); ++i) {
    Rgb light(first->values[i], (green ? green : first)->values[i], (blue ? blue : first)->values[i]);
    if (alpha) light += (1.0f - std::clamp(alpha->values[i], 0.0f, 1.0f)) * tone.background;
    const Rgb shown = toDisplay(light, tone);
    Rgb8 pixel{};
    for (int c = 0; c < 3; ++c)
      pixel[static_cast<size_t>(c)] =
          static_cast<uint8_t>(std::lround(255 * (std::isfinite(shown[c]) ? std::clamp(shown[c], 0.0f, 1.0f) : 0.0f)));
    raster.pixels.push_back(pixel);
  }
  return raster;
}

std::string pixelsText(const PictureExtent& extent) {
  return fmt::format("{} \xC3\x97 {} pixels", extent.width, extent.height);
}

std::string clothText(const Fabric& fabric) {
  std::string text = fmt::format("{} ends, {} picks", fabric.weave.ends(), fabric.weave.picks());
  if (fabric.draft) text += fmt::format(", {} shafts", fabric.draft->shafts);
  return text;
}

}  // namespace

FilePreviewDesk::FilePreviewDesk(std::function<void()> wake) : looks_(std::move(wake)) {}

FilePreviewDesk::Look FilePreviewDesk::lookInto(const std::string& file) {
  Look look;
  const auto showPng = [&look](const std::string& png) {
    const PictureExtent extent = readPngExtent(png);
    look.lines.push_back(pixelsText(extent));
    constexpr double kBytes = 12;  // of 16 bits a channel, then of 8
    if (isLight(extent, kBytes)) look.picture = small(rasterOf(readPng(png)));
  };
  const auto showExr = [&look](const std::string& exr) {
    const PictureExtent extent = readExrExtent(exr);
    look.lines.push_back(pixelsText(extent));
    if (extent.channels > 0 && isLight(extent, 4.0 * extent.channels + 3)) look.picture = small(rasterOf(readExr(exr)));
  };
  const auto showCloth = [&look](const Fabric& fabric) {
    look.picture = draftPicture(fabric, kSide);
    look.lines.push_back(fabric.name);
    look.lines.push_back(clothText(fabric));
  };
  try {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return look;
    const uintmax_t bytes = fs::file_size(file);
    look.lines.push_back(sizeText(bytes) + dateText(file));
    if (bytes > kMostBytes) {
      look.lines.push_back("Too large to be looked into.");
      return look;
    }
    const std::string extension = lowerExtension(file);
    if (extension == ".png") showPng(file);
    if (extension == ".exr") showExr(file);
    if (extension == ".json") showCloth(readFabric(file));
    if (isWeavingFile(file)) showCloth(readWifFabric(file, Fabric{}, WifSizeChoice::keep).fabric);
  } catch (const std::bad_alloc&) {
    look.lines.push_back("It needs more memory than there is.");
  } catch (const std::exception&) {
    look.lines.push_back(lowerExtension(file) == ".json" ? "It holds no cloth." : "It cannot be read.");
  }
  return look;
}

void FilePreviewDesk::take() {
  auto come = looks_.take();
  if (!come) return;
  constexpr size_t kMostKnown = 32;
  if (known_.size() >= kMostKnown) known_.clear();
  Known& known = known_[come->first];
  const Pixels8& picture = come->second.picture;
  if (!picture.bytes.empty()) {
    known.texture = std::make_unique<PictureTexture>();
    known.texture->upload(picture);
    known.preview.picture = known.texture->id();
    known.preview.size = ImVec2(static_cast<float>(picture.width), static_cast<float>(picture.height));
  }
  known.preview.lines = std::move(come->second.lines);
}

FilePreview FilePreviewDesk::of(const std::string& file) {
  take();
  if (const auto found = known_.find(file); found != known_.end()) return found->second.preview;
  if (file != asked_) {
    asked_ = file;
    looks_.ask([file](const auto&) { return std::pair(file, lookInto(file)); });
  }
  FilePreview coming;
  coming.isComing = !file.empty();
  return coming;
}

void FilePreviewDesk::forget() {
  looks_.forget();
  asked_.clear();
  known_.clear();
}

}  // namespace loomlight
