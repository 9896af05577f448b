#include "app/export/sample_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

// How it works. Parts of a picture are boxes in the space of x, y and the sample's number. What is missing begins as
// the whole box; each part that is there is cut out of what is left, which leaves at most two pieces on each axis.

namespace loomlight {
namespace {

bool overlap(const SampleBox& a, const SampleBox& b) {
  return glm::all(glm::lessThan(a.low, b.high)) && glm::all(glm::lessThan(b.low, a.high));
}

void cutOut(const SampleBox& hole, SampleBox left, std::vector<SampleBox>& rest) {
  for (int axis = 0; axis < 3; ++axis) {
    if (left.low[axis] < hole.low[axis]) {
      SampleBox before = left;
      before.high[axis] = left.low[axis] = hole.low[axis];
      rest.push_back(before);
    }
    if (left.high[axis] > hole.high[axis]) {
      SampleBox behind = left;
      behind.low[axis] = left.high[axis] = hole.high[axis];
      rest.push_back(behind);
    }
  }
}

/// Orders boxes so that those which lie in a row along an axis follow one another.
std::array<int, 6> inRowsAlong(int axis, const SampleBox& box) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return {box.low[u], box.high[u], box.low[v], box.high[v], box.low[axis], box.high[axis]};
}

bool continues(const SampleBox& next, const SampleBox& box, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return next.low[axis] == box.high[axis] && next.low[u] == box.low[u] && next.high[u] == box.high[u] &&
         next.low[v] == box.low[v] && next.high[v] == box.high[v];
}

}  // namespace

SampleBox SampleBox::of(const PixelRect& window, int firstSample, int samples) {
  return {{window.x, window.y, firstSample},
          {window.x + window.width, window.y + window.height, firstSample + samples}};
}

std::string inWords(const SampleBox& box) {
  const PixelRect window = box.window();
  return fmt::format("samples {} to {} of the pixels {},{},{}x{}", box.low.z, box.high.z - 1, window.x, window.y,
                     window.width, window.height);
}

std::optional<std::pair<size_t, size_t>> findOverlap(std::span<const SampleBox> boxes) {
  for (size_t i = 0; i < boxes.size(); ++i)
    for (size_t k = i + 1; k < boxes.size(); ++k)
      if (overlap(boxes[i], boxes[k])) return std::pair(i, k);
  return std::nullopt;
}

std::vector<SampleBox> missingFrom(const SampleBox& picture, std::vector<SampleBox> boxes) {
  std::vector<SampleBox> missing{picture};
  for (const SampleBox& box : joined(std::move(boxes))) {
    std::vector<SampleBox> rest;
    for (const SampleBox& left : missing) {
      if (overlap(left, box))
        cutOut(box, left, rest);
      else
        rest.push_back(left);
    }
    missing = std::move(rest);
  }
  return joined(std::move(missing));
}

std::vector<SampleBox> joined(std::vector<SampleBox> boxes) {
  for (int axis = 2; axis >= 0; --axis) {
    std::sort(boxes.begin(), boxes.end(),
              [axis](const SampleBox& a, const SampleBox& b) { return inRowsAlong(axis, a) < inRowsAlong(axis, b); });
    std::vector<SampleBox> fewer;
    for (const SampleBox& box : boxes) {
      if (!fewer.empty() && continues(box, fewer.back(), axis))
        fewer.back().high[axis] = box.high[axis];
      else
        fewer.push_back(box);
    }
    boxes = std::move(fewer);
  }
  return boxes;
}

PixelRect windowAround(std::span<const SampleBox> boxes) {
  SampleBox around = boxes.front();
  for (const SampleBox& box : boxes) {
    around.low = glm::min(around.low, box.low);
    around.high = glm::max(around.high, box.high);
  }
  return around.window();
}

}  // namespace loomlight
