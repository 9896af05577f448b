#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/validate.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_medium.h"

namespace loomlight {
namespace {

constexpr int kSide = 16;
constexpr uint32_t kSamples = 2;

/// A small blend in which no field is idle: cabled, plied and twisted, hairy, migrating, its number of fibres from its
/// count.
Fabric blend() {
  Fabric fabric;
  fabric.fibres = {Fibre{}, Fibre{}, Fibre{}};
  fabric.fibres[0].absorption_per_mm = Rgb(10, 4, 2);
  fabric.fibres[1].radius_um = 8;
  fabric.fibres[1].absorption_per_mm = Rgb(1, 5, 20);
  fabric.fibres[2].refractiveIndex = 1.5;
  Yarn& yarn = fabric.yarns[0];
  yarn.blendFibre = 1;
  yarn.blendShare = 0.4;
  yarn.count_tex = 6;
  yarn.plies = yarn.cords = 2;
  yarn.yarnTwist_per_m = 400;
  yarn.cableTwist_per_m = 300;
  yarn.hairiness_per_mm = 5;
  yarn.migration = 0.3;
  fabric.ends_per_cm = fabric.picks_per_cm = 24;
  fabric.drape.width_mm = fabric.drape.height_mm = 1;
  fabric.camera.distance_mm = 3;
  fabric.render.resolution = 2;
  return fabric;
}

/// The same with its count from its number of fibres.
Fabric blendByNumber() {
  Fabric fabric = blend();
  fabric.yarns[0].fibresPerPly = 4;
  return fabric;
}

/// Another value of a field, within its range.
template <class Value>
Value another(const Value& value, const FieldInfo& info) {
  if constexpr (std::is_same_v<Value, std::string>) {
    return value + " too";
  } else if constexpr (std::is_same_v<Value, Rgb>) {
    return 1.5f * value + Rgb(1);
  } else if constexpr (std::is_enum_v<Value>) {
    return static_cast<Value>((static_cast<size_t>(value) + 1) % ChoiceNames<Value>::names.size());
  } else if constexpr (std::is_same_v<Value, double>) {
    const double more = value > 0 ? 1.3 * value : info.min + 0.3 * (info.max - info.min);
    return more <= info.max ? more : 0.7 * value;
  } else if constexpr (std::is_same_v<Value, int>) {
    return value < info.max ? value + 1 : value - 1;
  } else {  // std::optional
    return value ? another(*value, info) : typename Value::value_type(info.min);
  }
}

/// A label says what something is called; all else is there to be seen.
template <class Value>
constexpr bool kIsLabel = std::is_same_v<Value, std::string>;

using Picture = std::vector<glm::vec4>;

struct Cloth {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Medium> medium;

  Picture picture() const {
    Film film(kSide, kSide);
    renderUpTo(kSamples, *scene, *medium, CameraRays(scene->fabric->camera, kSide, kSide), film, oneThread());
    Picture picture;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) picture.emplace_back(film.mean(x, y), film.alpha(x, y));
    return picture;
  }
};

class EveryField : public testing::TestWithParam<test::MediumKind> {
 protected:
  Cloth made(Fabric fabric) const {
    fabric.render.method = GetParam().method;
    fabric.render.estimator = GetParam().estimator;
    const auto scene = test::sceneOf(fabric);
    return {scene, GetParam().make(*scene)};
  }
  /// As the editor makes it: with all of the cloth before that serves again.
  Cloth edited(const Cloth& before, const Fabric& fabric) const {
    const auto scene = makeScene(std::make_shared<const Fabric>(fabric), Task{}, before.scene.get());
    if (before.scene->cloth == scene->cloth) return {scene, before.medium};
    return {scene, GetParam().make(*scene)};
  }

  /// Of the object that `select` finds in a fabric.
  template <class Object, class Select>
  void expectSeen(Select&& select) {
    const Cloth byCount = made(blend()), byNumber = made(blendByNumber());
    const Picture pictures[] = {byCount.picture(), byNumber.picture()};
    forEachField<Object>([&](const auto& field) {
      using Value = std::decay_t<decltype(std::declval<Object>().*field.member)>;
      SCOPED_TRACE(field.info.key);
      const auto isSeenIn = [&](const Cloth& cloth, const Picture& before) {
        Fabric fabric = *cloth.scene->fabric;
        Value& value = select(fabric).*field.member;
        value = another(value, field.info);
        validate(fabric, "a cloth with another value");
        const Picture picture = made(fabric).picture();
        EXPECT_EQ(edited(cloth, fabric).picture(), picture) << "what was kept of the cloth before is out of date";
        return picture != before;
      };
      const bool isSeen = isSeenIn(byCount, pictures[0]) || isSeenIn(byNumber, pictures[1]);
      EXPECT_EQ(isSeen, !kIsLabel<Value>);
    });
  }
};

// A field of which no picture knows is a promise to the designer that is not kept; a label that changes the picture
// draws other random numbers, or throws work away.
TEST_P(EveryField, OfAFibreIsSeen) {
  expectSeen<Fibre>([](Fabric& fabric) -> Fibre& { return fabric.fibres[0]; });
}

TEST_P(EveryField, OfABlendedFibreIsSeen) {
  expectSeen<Fibre>([](Fabric& fabric) -> Fibre& { return fabric.fibres[1]; });
}

TEST_P(EveryField, OfAYarnIsSeen) {
  expectSeen<Yarn>([](Fabric& fabric) -> Yarn& { return fabric.yarns[0]; });
}

INSTANTIATE_TEST_SUITE_P(Every, EveryField,
                         testing::Values(test::kPlain, test::kReport, test::kLoomlight, test::kFibres),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace loomlight
