#include "render/light/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "render/film/pixel_rect.h"
#include "render/light/lat_long.h"

// How it works. Each of the surroundings is a function of direction, averaged over the texels of a map of all
// directions, and scaled such that white paper that lies in it has radiance 1. A room is a box with one luminous
// rectangle: its walls are lit straight from that, by a sum over patches of it, and by each other alike everywhere.

namespace loomlight {
namespace {

constexpr int kWidth = 256, kHeight = kWidth / 2;

using Radiance = std::function<double(glm::dvec3 direction)>;

/// What white paper that lies in it is lit by, over pi: its radiance.
double paperUnder(const Image& image) {
  const std::vector<float>& values = image.channels[0].values;
  double sum = 0;
  for (int y = 0; y < kHeight / 2; ++y) {
    const double top = std::cos(kPi * y / kHeight), bottom = std::cos(kPi * (y + 1) / kHeight);
    const double perTexel = (top * top - bottom * bottom) * kPi / kWidth;  // solid angle times cosine
    for (int x = 0; x < kWidth; ++x) sum += perTexel * values[pixelIndex(x, y, kWidth)];
  }
  return sum / kPi;
}

/// Each texel is a mean over it.
Image imageOf(const Radiance& radiance) {
  constexpr int kPerTexel = 4;
  Image image;
  image.width = kWidth;
  image.height = kHeight;
  std::vector<float> values(pixelCount(kWidth, kHeight));
  parallelFor(kHeight, 0, [&](size_t y) {
    for (size_t x = 0; x < kWidth; ++x) {
      double sum = 0;
      for (int j = 0; j < kPerTexel; ++j)
        for (int i = 0; i < kPerTexel; ++i) {
          const auto u = (static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / kPerTexel) / kWidth;
          const double v = (static_cast<double>(y) + (j + 0.5) / kPerTexel) / kHeight;
          sum += radiance(glm::dvec3(latLongDirection(u, static_cast<float>(std::cos(kPi * v)))));
        }
      values[y * kWidth + x] = static_cast<float>(sum / (kPerTexel * kPerTexel));
    }
  });
  for (const char* name : {"R", "G", "B"}) image.add(name) = values;
  const auto scale = static_cast<float>(1 / paperUnder(image));
  for (Image::Channel& channel : image.channels)
    for (float& value : channel.values) value *= scale;
  return image;
}

/// A box about the cloth, with one luminous rectangle in one of its six faces. Metres; the cloth is at the origin.
struct Room {
  glm::dvec3 lower, upper;
  double albedo = 0.5;
  int axis = 2;  ///< of the face with the rectangle, and whether it is the upper one of the two
  bool upperFace = true;
  glm::dvec3 panelLower, panelUpper;  ///< of the rectangle; along the axis, what the face has

  double face() const { return upperFace ? upper[axis] : lower[axis]; }
  double panelArea() const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (panelUpper[u] - panelLower[u]) * (panelUpper[v] - panelLower[v]);
  }
  bool inPanel(glm::dvec3 p) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return std::abs(p[axis] - face()) < 1e-9 && p[u] >= panelLower[u] && p[u] <= panelUpper[u] &&
           p[v] >= panelLower[v] && p[v] <= panelUpper[v];
  }
};

struct Wall {
  glm::dvec3 point, inward;
};

Wall wallSeen(const Room& room, glm::dvec3 d) {
  double nearest = std::numeric_limits<double>::infinity();
  Wall wall{};
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) continue;
    const double t = (d[axis] > 0 ? room.upper : room.lower)[axis] / d[axis];
    if (t >= nearest) continue;
    nearest = t;
    wall.inward = glm::dvec3(0);
    wall.inward[axis] = d[axis] > 0 ? -1 : 1;
  }
  wall.point = nearest * d;
  for (int axis = 0; axis < 3; ++axis)
    if (wall.inward[axis] != 0) wall.point[axis] = wall.inward[axis] < 0 ? room.upper[axis] : room.lower[axis];
  return wall;
}

constexpr int kPatches = 4;  // that the rectangle is divided into, a side
using Patches = std::array<glm::dvec3, kPatches * kPatches>;

/// The middles of the patches that the rectangle is divided into.
Patches patchesOf(const Room& room) {
  const int u = (room.axis + 1) % 3, v = (room.axis + 2) % 3;
  Patches patches;
  for (int i = 0; i < kPatches * kPatches; ++i) {
    const int column = i % kPatches, row = i / kPatches;
    glm::dvec3& p = patches[static_cast<size_t>(i)];
    p[room.axis] = room.face();
    p[u] = room.panelLower[u] + (room.panelUpper[u] - room.panelLower[u]) * (column + 0.5) / kPatches;
    p[v] = room.panelLower[v] + (room.panelUpper[v] - room.panelLower[v]) * (row + 0.5) / kPatches;
  }
  return patches;
}

/// Irradiance on a wall straight from the rectangle, of radiance 1.
double fromPanel(const Room& room, const Patches& patches, const Wall& wall) {
  double sum = 0;
  for (const glm::dvec3& p : patches) {
    const glm::dvec3 way = p - wall.point;
    const double square = glm::dot(way, way);
    const double there = glm::dot(way, wall.inward), here = (room.upperFace ? 1 : -1) * way[room.axis];
    if (there > 0 && here > 0) sum += there * here / (square * square);
  }
  return sum * room.panelArea() / (kPatches * kPatches);
}

/// Walls lit straight, and by one another alike everywhere (the split flux method of daylighting).
Radiance insideOf(const Room& room, const Radiance& panel) {
  const glm::dvec3 size = room.upper - room.lower;
  const double walls = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  const double flux = kPi * room.panelArea();
  const double among = room.albedo * flux / (walls * (1 - room.albedo));
  return [=, patches = patchesOf(room)](glm::dvec3 d) {
    const Wall wall = wallSeen(room, d);
    if (room.inPanel(wall.point)) return panel(d);
    return room.albedo / kPi * (fromPanel(room, patches, wall) + among);
  };
}

double overcast(glm::dvec3 d) {
  const double zenith = 9.0 / 7.0;  // of a sky that gives paper radiance 1
  return d.z > 0 ? zenith * (1 + 2 * d.z) / 3 : 0.2;
}

}  // namespace

Image overcastSky() {
  return imageOf(overcast);
}

Image windowedRoom() {
  Room room;
  room.lower = {-3.5, -2, -0.75};
  room.upper = {1.5, 2, 1.85};
  room.albedo = 0.6;
  room.axis = 0;
  room.panelLower = {0, -0.9, 0.1};
  room.panelUpper = {0, 0.9, 1.5};
  return imageOf(insideOf(room, overcast));
}

Image lightBooth() {
  Room room;
  room.lower = {-0.3, -0.45, -0.02};
  room.upper = {0.3, 0.45, 0.6};
  room.albedo = 0.43;  // Munsell N7
  room.panelLower = {-0.2, -0.38, 0};
  room.panelUpper = {0.2, 0.38, 0};
  const Radiance inside = insideOf(room, [](glm::dvec3) { return 1.0; });
  return imageOf([=](glm::dvec3 d) {
    constexpr double kDarkRoom = 0.01;
    return wallSeen(room, d).inward.x < 0 ? kDarkRoom : inside(d);
  });
}

}  // namespace loomlight
