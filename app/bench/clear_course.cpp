#include "app/bench/clear_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <utility>

#include "app/cli/version_text.h"
#include "core/base/checksum.h"
#include "core/base/rgb.h"
#include "core/fabric/json/fabric_json.h"
#include "render/colour/tone.h"
#include "render/display/resample.h"
#include "render/film/image.h"
#include "render/metrics/flip.h"
#include "render/scene/scene.h"
#include "render/transport/make_medium.h"

namespace loomlight {
namespace {

constexpr uint64_t kReferenceSeed = 0x5EED;
constexpr int kAcross = 3;  // windows each way

/// A twentieth of the picture each way, at least as large as an eye blurs: few pixels, so that many samples are cheap.
/// A reference that is noisy itself is far from every clear picture.
std::vector<PixelRect> windowsIn(int width, int height) {
  constexpr int kLeast_px = kLeastClearSide_px / kAcross;
  const int w = std::max(kLeast_px, width / 20), h = std::max(kLeast_px, height / 20);
  std::vector<PixelRect> windows;
  for (int row = 0; row < kAcross; ++row)
    for (int column = 0; column < kAcross; ++column)
      windows.push_back(
          {(2 * column + 1) * width / (2 * kAcross) - w / 2, (2 * row + 1) * height / (2 * kAcross) - h / 2, w, h});
  return windows;
}

/// What the display makes of premultiplied light: FLIP starts from light.
Rgb displayed(const glm::vec4& pixel) {
  const Tone tone;
  const Rgb encoded = toDisplay(Rgb(pixel) + (1 - pixel.a) * tone.background, tone);
  return {decodeSrgb(encoded.r), decodeSrgb(encoded.g), decodeSrgb(encoded.b)};
}

using Windows = std::vector<LinearPicture>;

LinearPicture windowOf(const Film& film, const PixelRect& rect) {
  LinearPicture window{rect.width, rect.height, {}};
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x)
      window.pixels.push_back(displayed(glm::vec4(film.mean(x, y), film.alpha(x, y))));
  return window;
}

/// All windows below each other, of the one list and then of the other.
Image imageOf(const Windows& windows, const Windows& halfway) {
  Image image;
  image.width = windows.front().width;
  image.height = static_cast<int>(windows.size() + halfway.size()) * windows.front().height;
  for (const char* name : {"R", "G", "B"}) image.add(name);
  for (int c = 0; c < 3; ++c) {
    size_t i = 0;
    for (const Windows* list : {&windows, &halfway})
      for (const LinearPicture& window : *list)
        for (const Rgb& pixel : window.pixels) image.channels[c].values[i++] = pixel[c];
  }
  return image;
}

size_t pixelsIn(const std::vector<PixelRect>& rects) {
  size_t pixels = 0;
  for (const PixelRect& rect : rects) pixels += static_cast<size_t>(rect.width) * static_cast<size_t>(rect.height);
  return pixels;
}

/// The windows from this pixel of such an image on, which is then that after them.
Windows windowsFrom(std::span<const Rgb>& pixels, const std::vector<PixelRect>& rects) {
  Windows windows;
  for (const PixelRect& rect : rects) {
    const auto those = pixels.first(static_cast<size_t>(rect.width) * static_cast<size_t>(rect.height));
    windows.push_back({rect.width, rect.height, {those.begin(), those.end()}});
    pixels = pixels.subspan(those.size());
  }
  return windows;
}

/// Mean FLIP over all of them.
double meanFlip(const Windows& shown, const Windows& reference, int threads) {
  double sum = 0;
  size_t pixels = 0;
  for (size_t i = 0; i < reference.size(); ++i) {
    for (const float error : flip(shown[i], reference[i], Viewing{}, threads)) sum += error;
    pixels += reference[i].pixels.size();
  }
  return sum / static_cast<double>(std::max<size_t>(1, pixels));
}

}  // namespace

double ClearCourse::at(double since_s) const {
  double flip = 1;
  for (const Point& point : points)
    if (point.since_s <= since_s) flip = point.flip;
  return flip;
}

double ClearCourse::timeTo(double flip) const {
  for (const Point& point : points)
    if (point.flip <= flip) return point.since_s;
  return std::numeric_limits<double>::infinity();
}

double ClearCourse::worstStepBack() const {
  double worst = 1, best = std::numeric_limits<double>::infinity();
  for (const Point& point : points) {
    if (best > 0) worst = std::max(worst, point.flip / best);
    best = std::min(best, point.flip);
  }
  return worst;
}

ClearReference::ClearReference(const Fabric& fabric, const ClearReferenceTask& of, const Task& task)
    : width_(of.width), height_(of.height) {
  Fabric seeded = fabric;
  seeded.render.seed = kReferenceSeed;
  // Another program may trace it otherwise, or look at other windows.
  const uint64_t key =
      hashBytes(hashBytes(hashCombine(hashCombine(hashCombine(0, width_), height_), of.samples), fabricToJson(seeded)),
                buildName());
  std::filesystem::create_directories(of.folder);
  const std::string file = fmt::format("{}/{:016x}.exr", of.folder, key);
  const std::vector<PixelRect> rects = windowsIn(width_, height_);
  if (std::filesystem::exists(file)) {
    const LinearPicture kept = readLinearPicture(file);
    std::span<const Rgb> pixels = kept.pixels;
    if (pixels.size() == 2 * pixelsIn(rects)) {  // else another program of this name looked at other windows
      windows_ = windowsFrom(pixels, rects);
      halfway_ = windowsFrom(pixels, rects);
      return;
    }
  }
  const auto scene = makeScene(std::make_shared<const Fabric>(seeded), task);
  if (!scene) return;
  const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), task);
  if (!medium) return;
  Film film(width_, height_);
  const CameraRays camera(seeded.camera, width_, height_);
  for (const PixelRect& rect : rects) {
    for (const auto& [samples, windows] :
         {std::pair(std::max(1u, of.samples / 2), &halfway_), {of.samples, &windows_}}) {
      if (!renderUpTo(samples, *scene, *medium, camera, film, task, {.window = rect}).complete) return;
      windows->push_back(windowOf(film, rect));
    }
  }
  writeExr(file, imageOf(windows_, halfway_));
}

std::vector<LinearPicture> ClearReference::windowsOf(const Frame& frame) const {
  std::vector<LinearPicture> windows;
  const auto columns = [&](int x) { return Between(x, 1.0f / static_cast<float>(frame.divider), 0, frame.width); };
  const auto rows = [&](int y) { return Between(y, 1.0f / static_cast<float>(frame.divider), 0, frame.height); };
  for (const PixelRect& rect : windowsIn(width_, height_)) {
    LinearPicture& window = windows.emplace_back();
    window = {rect.width, rect.height, {}};
    for (int y = rect.y; y < rect.y + rect.height; ++y)
      for (int x = rect.x; x < rect.x + rect.width; ++x)
        window.pixels.push_back(displayed(resampled(frame.shown(), frame.width, columns(x), rows(y))));
  }
  return windows;
}

double ClearReference::distance(const std::vector<LinearPicture>& shown, int threads) const {
  return meanFlip(shown, windows_, threads);
}

double ClearReference::noise(int threads) const {
  return meanFlip(halfway_, windows_, threads);
}

ClearCourse watchClear(LiveClock& clock, const Fabric& fabric, const ClearReference& reference, double seconds,
                       const std::vector<double>& times_s, std::vector<std::shared_ptr<const Frame>>* pictures,
                       const Task& task) {
  struct Shown {
    std::vector<LinearPicture> windows;
    ClearCourse::Point point;
  };
  std::vector<Shown> shown;
  if (pictures) pictures->assign(times_s.size(), nullptr);
  const auto look = [&](const std::shared_ptr<const Frame>& frame, double since_s) {
    shown.push_back({reference.windowsOf(*frame), {since_s, 0, frame->samples}});
    for (size_t i = 0; pictures && i < times_s.size(); ++i)
      if (since_s <= times_s[i]) (*pictures)[i] = frame;
  };
  ClearCourse course;
  if (!clock.watch(fabric, seconds, look, task.stop)) return course;
  clock.pause(true);
  for (Shown& one : shown) {
    one.point.flip = reference.distance(one.windows, task.threads);
    course.points.push_back(one.point);
  }
  clock.pause(false);
  return course;
}

}  // namespace loomlight
