#include "render/display/patch.h"

#include <algorithm>
#include <cassert>

#include "core/base/modulo.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/display/despeckle.h"
#include "render/display/resample.h"

// How it works. After crossings were turned, the last clear picture is right wherever no turned crossing is seen. The
// new, coarse picture is put in where it shows a thread that the old one does not have there and a turned crossing is
// in reach of it, and where the old one shows a turned crossing. Its share fades out beyond those pixels, so that the
// patch has no border.

namespace loomlight {
namespace {

bool sameCrossing(const Film::Hit& a, const Film::Hit& b) {
  return a.yarn == b.yarn && a.end == b.end && a.pick == b.pick;
}

/// For each pixel of the new picture, whether the old one shows nothing like it there: about the same pixels, as a
/// sample may lie anywhere in a coarse one and the next yarn may have moved a little.
std::vector<bool> newlySeen(const Frame& fresh, const Frame& old) {
  assert(fresh.width >= coarser(old.width, fresh.divider));
  const int size = fresh.divider, around = std::max(1, size / 4);
  std::vector<bool> changed(fresh.hits.size(), true);
  for (int y = 0; y < fresh.height; ++y)
    for (int x = 0; x < fresh.width; ++x) {
      const size_t i = pixelIndex(x, y, fresh.width);
      const int right = std::min(old.width, (x + 1) * size + around), left = std::max(0, x * size - around);
      for (int v = std::max(0, y * size - around); v < std::min(old.height, (y + 1) * size + around); ++v) {
        const Film::Hit* row = &old.hits[static_cast<size_t>(v) * static_cast<size_t>(old.width)];
        if (std::none_of(row + left, row + right, [&](const Film::Hit& h) { return sameCrossing(h, fresh.hits[i]); }))
          continue;
        changed[i] = false;
        break;
      }
    }
  return changed;
}

bool isTurned(const Weave& now, const Weave& then, int pick, int end) {
  const int p = wrap(pick, now.picks()), e = wrap(end, now.ends());
  return now.at(p, e) != then.at(p, e);
}

/// Whether a crossing has been turned so near that what is seen here may have changed: along the yarns that cross
/// there, and on the threads beside them, and where threads crowd also on those beside these.
bool isNearTurned(const Weave& now, const Weave& then, const Film::Hit& hit, bool crowded) {
  constexpr int kReach = kCrossingReach;
  const int farthest = crowded ? 2 : 1;
  if (hit.end < 0 || hit.pick < 0) return false;  // a gap
  for (int along = -kReach; along <= kReach; ++along)
    for (int beside = -farthest; beside <= farthest; ++beside)
      if (isTurned(now, then, hit.pick + along, hit.end + beside) ||
          isTurned(now, then, hit.pick + beside, hit.end + along))
        return true;
  return false;
}

/// The pixel of the old picture in the middle of one of the new.
size_t middleOf(size_t pixel, const Frame& fresh, const Frame& old) {
  const auto width = static_cast<size_t>(fresh.width), size = static_cast<size_t>(fresh.divider);
  const size_t x = std::min(pixel % width * size + size / 2, static_cast<size_t>(old.width) - 1);
  const size_t y = std::min(pixel / width * size + size / 2, static_cast<size_t>(old.height) - 1);
  return y * static_cast<size_t>(old.width) + x;
}

/// Marks the pixels of the new picture where the old one shows crossings that have been turned: a coarse picture's
/// samples may all have missed them.
void addTurned(std::vector<bool>& changed, const Frame& fresh, const Frame& old, const Weave& now, const Weave& then) {
  for (int y = 0; y < old.height; ++y)
    for (int x = 0; x < old.width; ++x) {
      const Film::Hit& hit = old.hits[pixelIndex(x, y, old.width)];
      if (hit.end < 0 || hit.pick < 0) continue;
      if (!isTurned(now, then, hit.pick, hit.end)) continue;
      changed[pixelIndex(x / fresh.divider, y / fresh.divider, fresh.width)] = true;
    }
}

/// The pixels that are at most so far from one of these, along both axes.
std::vector<bool> around(const std::vector<bool>& pixels, int width, int height, int distance) {
  std::vector<bool> wider(pixels.size(), false);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!pixels[pixelIndex(x, y, width)]) continue;
      for (int v = std::max(0, y - distance); v <= std::min(height - 1, y + distance); ++v)
        for (int u = std::max(0, x - distance); u <= std::min(width - 1, x + distance); ++u)
          wider[pixelIndex(u, v, width)] = true;
    }
  return wider;
}

/// How much of the new picture is seen at each of its pixels: all of it where it changes, and beyond their neighbours
/// ever less, so that no border is a line. Enlarging a coarse picture does that on its own.
std::vector<glm::vec4> sharesOf(const std::vector<bool>& changed, const Frame& fresh) {
  constexpr int kSoftPixels = 2;  // of the viewport, to each side
  const int softened = kSoftPixels / fresh.divider;
  const std::vector<bool> seen = around(changed, fresh.width, fresh.height, 1 + softened);
  std::vector<glm::vec4> shares(changed.size(), glm::vec4(0));
  for (size_t i = 0; i < seen.size(); ++i)
    if (seen[i]) shares[i] = glm::vec4(1);
  for (int i = 0; i < softened; ++i) soften(shares, fresh.width, fresh.height);
  return shares;
}

}  // namespace

Frame patched(Frame fresh, const Frame& old, const Weave& weaveNow, const Weave& weaveThen, bool crowded) {
  std::vector<bool> changed = newlySeen(fresh, old);
  for (size_t i = 0; i < changed.size(); ++i) {
    if (!changed[i]) continue;
    // A single sample falls through gaps where one of many has met a yarn: that one says what is there.
    const Film::Hit& hit = fresh.hits[i].end >= 0 ? fresh.hits[i] : old.hits[middleOf(i, fresh, old)];
    changed[i] = isNearTurned(weaveNow, weaveThen, hit, crowded);
  }
  addTurned(changed, fresh, old, weaveNow, weaveThen);
  const std::vector<glm::vec4> shares = sharesOf(changed, fresh);
  Frame whole = old;
  whole.generation = fresh.generation;
  whole.samples = fresh.samples;
  whole.seconds = fresh.seconds;
  whole.quality = std::min(fresh.quality, old.quality);
  whole.shared = fresh.shared;
  const bool denoised = !fresh.denoised.empty() && !old.denoised.empty();
  if (!denoised) whole.denoised.clear();
  const bool helped = !fresh.helped.empty() || !old.helped.empty();
  if (helped) whole.helped.assign(old.plain().begin(), old.plain().end());
  const float ratio = 1.0f / static_cast<float>(fresh.divider);
  for (int y = 0; y < old.height; ++y)
    for (int x = 0; x < old.width; ++x) {
      const size_t coarse = pixelIndex(x / fresh.divider, y / fresh.divider, fresh.width);
      const Between u(x, ratio, 0, fresh.width), v(y, ratio, 0, fresh.height);
      const float share = resampled(shares, fresh.width, u, v).x;
      if (share == 0) continue;
      const size_t i = pixelIndex(x, y, old.width);
      whole.rgba[i] = glm::mix(old.rgba[i], resampled(fresh.rgba, fresh.width, u, v), share);
      if (helped) whole.helped[i] = glm::mix(whole.helped[i], resampled(fresh.plain(), fresh.width, u, v), share);
      if (denoised) whole.denoised[i] = glm::mix(old.denoised[i], resampled(fresh.denoised, fresh.width, u, v), share);
      if (changed[coarse]) whole.hits[i] = fresh.hits[coarse];
    }
  return whole;
}

}  // namespace loomlight
