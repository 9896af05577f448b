#include "app/editor/services/file_preview_service.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "app/export/draft_picture.h"
#include "app/export/file_name.h"
#include "core/base/text.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/swatch/measured_swatch.h"
#include "core/fabric/weave/picture_weave.h"
#include "core/fabric/wif/wif_fabric.h"
#include "render/colour/illuminants.h"
#include "render/colour/tone.h"
#include "render/display/display_picture.h"
#include "render/display/raster.h"
#include "render/transport/reached_colours.h"
#include "ui/words/common_words.h"
#include "ui/words/file_words.h"

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
  if (bytes < 1000) return words::files::tiny;
  const double kB = 1e-3 * static_cast<double>(bytes);
  return kB < 1000 ? fmt::format("{:.0f} kB", kB) : fmt::format("{:.1f} MB", 1e-3 * kB);
}

std::string dateText(const std::string& file) {
  struct stat status{};
  std::tm local{};
  if (stat(file.c_str(), &status) != 0 || !localtime_r(&status.st_mtime, &local)) return {};
  return fmt::format(", {:04}-{:02}-{:02} {:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                     local.tm_hour, local.tm_min);
}

Pixels8 small(const Pixels8& picture) {
  const Raster reduced = reducedTo(rasterOf(picture), kSide);
  Pixels8 pixels{reduced.width, reduced.height, 3, {}};
  pixels.bytes.reserve(3 * reduced.pixels.size());
  for (const Rgb8& c : reduced.pixels) pixels.bytes.insert(pixels.bytes.end(), c.begin(), c.end());
  return pixels;
}

/// Light as the display shows it, on the grey of the surround where the picture is transparent.
Pixels8 displayed(const Image& image) {
  const Image::Channel *const red = image.find("R"), *const green = image.find("G"), *const blue = image.find("B");
  const Image::Channel* const alpha = image.find("A");
  const Image::Channel* const first = red ? red : image.find("Y") ? image.find("Y") : &image.channels.front();
  const auto finite = [](float value) { return std::isfinite(value) ? value : 0.0f; };
  Frame frame;
  frame.width = image.width;
  frame.height = image.height;
  frame.rgba.reserve(first->values.size());
  for (size_t i = 0; i < first->values.size(); ++i)
    frame.rgba.emplace_back(finite(first->values[i]), finite((green ? green : first)->values[i]),
                            finite((blue ? blue : first)->values[i]),
                            alpha ? std::clamp(finite(alpha->values[i]), 0.0f, 1.0f) : 1.0f);
  return displayPicture(frame, Tone{});
}

std::string pixelsText(const PictureExtent& extent) {
  return fmt::format(words::common::pixels, extent.width, extent.height);
}

std::string clothText(const Fabric& fabric) {
  std::string text = fmt::format(words::common::endsAndPicks, fabric.weave.ends(), fabric.weave.picks());
  if (fabric.draft) text += fmt::format(words::common::andShafts, fabric.draft->shafts);
  return text;
}

}  // namespace

FilePreviewService::FilePreviewService(DisplayDriver& driver, std::function<void()> wake)
    : driver_(driver),
      looks_(
          std::move(wake),
          [](const std::string& file, const auto& job) { return std::pair(file, lookInto(file, job)); },
          [](const std::string& file, const std::string& problem) { return std::pair(file, Look{{}, {problem}}); },
          Backlog::hanging) {}

FilePreviewService::Look FilePreviewService::lookInto(const std::string& file, const Looks::Job& job) {
  Look look;
  const auto showPng = [&look](const std::string& png) {
    const PictureExtent extent = readPngExtent(png);
    look.lines.push_back(pixelsText(extent));
    constexpr double kBytes = 12;  // of 16 bits a channel, then of 8
    if (isLight(extent, kBytes)) look.picture = small(readPng(png));
  };
  const auto showExr = [&look](const std::string& exr) {
    const PictureExtent extent = readExrExtent(exr);
    look.lines.push_back(pixelsText(extent));
    if (extent.channels > 0 && isLight(extent, 4.0 * extent.channels + 16 + 6))
      look.picture = small(displayed(readExr(exr)));
  };
  const auto showCloth = [&](const Fabric& fabric) {
    look.lines.push_back(fabric.name);
    look.lines.push_back(clothText(fabric));
    look.isComing = true;
    job.bring({file, look});
    Task task;
    task.stop = job.stop();
    task.threads = 1;
    const auto colours = soonReachedColours(fabric, task);
    if (colours) look.picture = draftPicture(fabric, *colours, kSide, kSide);
    look.isComing = false;
  };
  try {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return look;
    const uintmax_t bytes = fs::file_size(file);
    look.lines.push_back(sizeText(bytes) + dateText(file));
    if (bytes > kMostBytes) {
      look.lines.emplace_back(words::files::tooLarge);
      return look;
    }
    const std::string extension = lowerExtension(file);
    if (extension == ".png") showPng(file);
    if (extension == ".exr") showExr(file);
    if (isFabricFile(file)) showCloth(readFabric(file));
    if (isWeavingFile(file) && !isSwatchFile(file) && !isIlluminantFile(file))
      showCloth(readWifFabric(file, Fabric{}, WifSizeChoice::keep).fabric);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    look.lines.emplace_back(isFabricFile(file) ? words::files::holdsNoCloth : words::files::cannotBeRead);
  }
  return look;
}

void FilePreviewService::take() {
  auto come = looks_.take();
  if (!come) return;
  constexpr size_t kMostKnown = 32;
  if (known_.size() >= kMostKnown) known_.clear();
  Known& known = known_[come->first];
  const Pixels8& picture = come->second.picture;
  if (!picture.bytes.empty()) {
    known.texture = driver_.makeTexture();
    known.texture->upload(picture);
    known.preview.picture = known.texture->id();
    known.preview.size = ImVec2(static_cast<float>(picture.width), static_cast<float>(picture.height));
  }
  known.preview.lines = std::move(come->second.lines);
  known.preview.isComing = come->second.isComing;
}

FilePreview FilePreviewService::of(const std::string& file) {
  take();
  if (const auto found = known_.find(file); found != known_.end()) return found->second.preview;
  if (file != asked_) {
    asked_ = file;
    looks_.ask(file);
  }
  FilePreview coming;
  coming.isComing = !file.empty();
  return coming;
}

void FilePreviewService::forget() {
  looks_.forget();
  asked_.clear();
  known_.clear();
}

}  // namespace loomlight
