// How it works. The cloth of a tile is built once, and seen four times: from either side, lit by the half of the sky
// that this side faces, or by the other half. Light adds up, so the two pictures of a side make the one in light from
// everywhere. Which way fibres lie is heard of while the first of the two is traced: a fibre has an axis but no
// direction, so the angles are doubled before they are averaged, which makes both ends of an axis the same.
#include "app/export/handover/side_maps.h"

#include <cmath>

#include "app/export/task_part.h"
#include "app/export/whole_picture.h"
#include "core/fabric/model/validate.h"
#include "render/transport/make_medium.h"

namespace loomlight {
namespace {

/// Sums the axes of the first fibres of every pixel, with their angles doubled, in the world's xy-plane.
class FibreAxes final : public FirstFibreSink {
 public:
  FibreAxes(int width, int height)
      : width_(width), sums_(static_cast<size_t>(width) * static_cast<size_t>(height), glm::vec3(0)) {}

  void begin(size_t) override {}
  void sample(size_t, int x, int y, const Ray&, const Collision* first, const PathSample&) override {
    if (!first) return;
    const glm::vec3 t = first->tangent;
    // No two threads trace the same pixel.
    sums_[static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)] +=
        glm::vec3(t.x * t.x - t.y * t.y, 2 * t.x * t.y, 1);
  }

  /// `mirrored`: x runs the other way in the picture.
  std::vector<glm::vec2> axes(bool mirrored) const {
    std::vector<glm::vec2> axes;
    for (const glm::vec3& sum : sums_) {
      const float angle = 0.5f * std::atan2(mirrored ? -sum.y : sum.y, sum.x);  // -90 to 90 degrees
      const float length = sum.z > 0 ? std::hypot(sum.x, sum.y) / sum.z : 0.0f;
      axes.push_back(length * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return axes;
  }

 private:
  int width_;
  std::vector<glm::vec3> sums_;  ///< cosine and sine of twice the angle, each by how flat the fibre lies; samples
};

Fabric litFrom(Fabric scene, LightKind light) {
  scene.light.kind = light;
  return scene;
}

/// Pictures of a cloth that is built once.
class TileStudio {
 public:
  TileStudio(const Fabric& fabric, const TileExtent& extent, int longestSide, double limit_bytes)
      : fabric_(fabric), extent_(extent), longestSide_(longestSide), limit_bytes_(limit_bytes) {}

  /// False when stopped.
  bool build(const Task& task) {
    const auto first = std::make_shared<const Fabric>(sceneOf(ClothSide::front));
    validate(*first, fabric_.name + ": the tile");
    built_ = makeScene(first, partOf(task, 0, 0.5), SceneBase{nullptr, {}, extent_.tiling()});
    medium_ = built_ ? makeMedium(*built_, {limit_bytes_, FibreExtent::oneRepeat}, partOf(task, 0.5, 1)) : nullptr;
    return medium_ != nullptr;
  }

  std::optional<SideMaps> side(ClothSide side, const Task& task) const {
    const bool isFront = side == ClothSide::front;
    const Fabric scene = sceneOf(side);
    FibreAxes axes(scene.render.width, scene.render.height);
    auto lit = maps(litFrom(scene, isFront ? LightKind::dome : LightKind::back), &axes, partOf(task, 0, 0.5));
    if (!lit) return std::nullopt;
    auto through = maps(litFrom(scene, isFront ? LightKind::back : LightKind::dome), nullptr, partOf(task, 0.5, 1));
    if (!through) return std::nullopt;
    SideMaps maps;
    maps.reflected = lit->baseColour;
    maps.transmitted = std::move(through->baseColour);
    maps.tile = std::move(*lit);
    for (size_t i = 0; i < maps.transmitted.size(); ++i) maps.tile.baseColour[i] += maps.transmitted[i];
    maps.along = axes.axes(!isFront);
    return maps;
  }

 private:
  Fabric sceneOf(ClothSide side) const { return tileScene(fabric_, extent_, longestSide_, side); }

  std::optional<TileMaps> maps(const Fabric& fabric, FibreAxes* axes, const Task& task) const {
    const auto scene = makeScene(std::make_shared<const Fabric>(fabric), task, built_.get());
    const auto film = scene ? tracedFilm(*scene, *medium_, task, axes) : std::nullopt;
    return film ? std::optional(tileMaps(*film, fabric, task.threads)) : std::nullopt;
  }

  const Fabric& fabric_;
  const TileExtent extent_;
  const int longestSide_;
  const double limit_bytes_;
  std::shared_ptr<const Scene> built_;
  std::unique_ptr<const Medium> medium_;
};

}  // namespace

std::optional<TileSides> tileSides(const Fabric& fabric, const TileExtent& extent, int longestSide, double limit_bytes,
                                   const Task& task) {
  constexpr double kBuilt = 0.05, kHalf = 0.525;  // of the progress
  TileStudio studio(fabric, extent, longestSide, limit_bytes);
  if (!studio.build(partOf(task, 0, kBuilt))) return std::nullopt;
  auto front = studio.side(ClothSide::front, partOf(task, kBuilt, kHalf));
  if (!front) return std::nullopt;
  auto back = studio.side(ClothSide::back, partOf(task, kHalf, 1));
  if (!back) return std::nullopt;
  return TileSides{std::move(*front), std::move(*back)};
}

}  // namespace loomlight
