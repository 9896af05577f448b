#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/wif_origin.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_medium.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/surroundings.h"

namespace loomlight {
namespace {

constexpr uint32_t kSamples = 2;

/// A small blend in which no field is idle: cabled, plied and twisted, hairy, migrating, uneven with slubs, wrapped,
/// its threads of several shades, its number of fibres from its count. Paths are so short that many end by their
/// length. A second yarn, of another shape, is not in use.
Fabric blend() {
  Fabric fabric;
  fabric.fibres = {Fibre{}, Fibre{}, Fibre{}};
  fabric.fibres[0].absorption_per_mm = Rgb(10, 4, 2);
  fabric.fibres[1].radius_um = 8;
  fabric.fibres[1].absorption_per_mm = Rgb(1, 5, 20);
  fabric.fibres[2].refractiveIndex = 1.5;
  fabric.yarns.resize(2);
  Yarn& yarn = fabric.yarns[0];
  yarn.blendFibre = 1;
  yarn.blendShare = 0.4;
  yarn.count_tex = 6;
  yarn.plies = yarn.cords = 2;
  yarn.yarnTwist_per_m = 400;
  yarn.cableTwist_per_m = 300;
  yarn.hairiness_per_mm = 5;
  yarn.migration = 0.3;
  yarn.evennessCv_percent = 12;
  yarn.slubs_per_m = 20;
  yarn.shadeVariation_percent = 12;
  yarn.wrappers_per_cm = 10;
  fabric.yarns[1].count_tex = 4;
  fabric.ends_per_cm = fabric.picks_per_cm = 24;
  fabric.settCv_percent = 6;
  fabric.drape.width_mm = fabric.drape.height_mm = 1;
  fabric.camera.distance_mm = 3;
  fabric.render.resolution = 1;
  fabric.render.width = fabric.render.height = 16;
  fabric.render.maxDepth = 4;
  return fabric;
}

template <class Edit>
Fabric blendWith(Edit&& edit) {
  Fabric fabric = blend();
  edit(fabric);
  return fabric;
}

/// The same with its count from its number of fibres.
Fabric blendByNumber() {
  return blendWith([](Fabric& f) { f.yarns[0].fibresPerPly = 4; });
}

/// Another value of a field, within its range; of a file the name of another one beside it.
template <class Value>
Value another(const Value& value, const FieldInfo& info) {
  if constexpr (std::is_same_v<Value, std::string>) {
    const std::filesystem::path name(value);
    return (name.parent_path() / ("another " + name.filename().string())).string();
  } else if constexpr (std::is_same_v<Value, bool>) {
    return !value;
  } else if constexpr (std::is_same_v<Value, Absorption>) {
    Absorption more = value;  // of each kind that there is
    more.primaries += Rgb(0.3f);
    if (more.bands) (*more.bands)[20] += 5;
    for (Dyestuff& dye : more.dyes) dye.amount_percent *= 1.5;
    return more;
  } else if constexpr (std::is_same_v<Value, Spectrum>) {
    Spectrum more = value;
    more[20] += 5;
    return more;
  } else if constexpr (std::is_same_v<Value, Rgb> || std::is_same_v<Value, glm::dvec3>) {
    return value + Value(0.3);
  } else if constexpr (std::is_enum_v<Value>) {
    return static_cast<Value>((static_cast<size_t>(value) + 1) % ChoiceNames<Value>::names.size());
  } else if constexpr (std::is_same_v<Value, double>) {
    const double more = value > 0 ? 1.3 * value : info.min + 0.3 * (info.max - info.min);
    return more <= info.max ? more : 0.7 * value;
  } else if constexpr (std::is_integral_v<Value>) {
    return static_cast<double>(value) < info.max ? value + 1 : value - 1;
  } else {  // std::optional
    return value ? another(*value, info) : typename Value::value_type(info.min);
  }
}

/// Every number of it, in order.
using Picture = std::vector<glm::vec4>;

struct Cloth {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Medium> medium;

  const Fabric& fabric() const { return *scene->fabric; }

  /// As many pixels as the fabric asks for.
  Picture picture() const {
    const int width = fabric().render.width, height = fabric().render.height;
    Film film(width, height);
    renderUpTo(kSamples, *scene, *medium, CameraRays(fabric().camera, width, height), film, oneThread());
    Picture picture;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) picture.emplace_back(film.mean(x, y), film.alpha(x, y));
    return picture;
  }
};

Cloth made(const std::shared_ptr<const Scene>& scene) {
  const RenderSettings& render = scene->fabric->render;
  const test::MediumKind kind{.name = "", .method = render.method, .estimator = render.estimator};
  return {scene, kind.make(*scene, 1)};
}

/// As the editor makes it: with all of the cloth before that serves again.
Cloth edited(const Cloth& before, const Fabric& fabric) {
  const auto scene = makeScene(std::make_shared<const Fabric>(fabric), Task{}, before.scene.get());
  if (before.scene->cloth == scene->cloth) return {scene, before.medium};
  return made(scene);
}

/// Whether what the changes name has been made again, and nothing else.
void expectMadeAgain(const Changes& change, const Cloth& before, const Cloth& after) {
  const auto expectMade = [](const char* what, bool wanted, const auto& was, const auto& is) {
    EXPECT_EQ(was != is, wanted) << what;
  };
  const TraceData &then = *before.scene->cloth, &now = *after.scene->cloth;
  expectMade("volume", change.cloth(), then.volume, now.volume);
  expectMade("medium", change.medium(), before.medium, after.medium);
  expectMade("lighting", change.stages.any(Stage::light | Stage::brightness), before.scene->lighting,
             after.scene->lighting);
  if (change.stages.any(Stage::drape) || !change.cloth()) {
    expectMade("shell", change.stages.any(Stage::drape), then.shell, now.shell);
    expectMade("entry", change.stages.any(Stage::drape), then.entry, now.entry);
  }
  if (!change.cloth()) expectMade("fibres", false, then.fibres, now.fibres);
  for (int i = 0; i < static_cast<int>(std::min(then.materials.size(), now.materials.size())); ++i)
    expectMade("material", std::count(change.fibres.begin(), change.fibres.end(), i) > 0, then.materials[i].bcsdf,
               now.materials[i].bcsdf);
}

/// Edits the cloth and compares with the same made from nothing. Whether the picture has changed.
bool expectIncrementalIsFull(const Cloth& before, const Picture& pictureBefore, const Fabric& fabric) {
  validate(fabric, "a cloth with another value");
  const Changes change = changes(before.fabric(), fabric);
  const Cloth after = edited(before, fabric);
  expectMadeAgain(change, before, after);
  const Cloth full = made(test::sceneOf(fabric));
  const Picture picture = full.picture();
  EXPECT_TRUE(after.picture() == picture) << "what was kept of the cloth before is out of date";
  // The same sum, of the same shapes, which an edited map may have numbered in another order.
  const double mass = after.scene->cloth->volume->measure().arealMass_g_m2;
  EXPECT_NEAR(mass / full.scene->cloth->volume->measure().arealMass_g_m2, 1, 1e-12);
  const bool isSeen = picture != pictureBefore;
  EXPECT_TRUE(change.picture() || !isSeen) << "samples have been kept of another picture";
  return isSeen;
}

class FieldStages : public testing::TestWithParam<test::MediumKind> {
 protected:
  /// Of the object that `select` finds in a fabric. Each field is in use in one of the fabrics at least.
  template <class Object, class Select>
  void expectAllOf(std::vector<Fabric> fabrics, Select&& select) {
    std::vector<Cloth> cloths;
    std::vector<Picture> pictures;
    for (Fabric& fabric : fabrics) {
      fabric.render.method = GetParam().method;
      fabric.render.estimator = GetParam().estimator;
      pictures.push_back(cloths.emplace_back(made(test::sceneOf(fabric))).picture());
    }
    forEachField<Object>([&](const auto& field) {
      SCOPED_TRACE(field.info.key);
      Stages found;
      bool isSeen = false;
      for (size_t i = 0; i < cloths.size(); ++i) {
        SCOPED_TRACE("fabric " + std::to_string(i));
        Fabric fabric = cloths[i].fabric();
        auto& value = select(fabric).*field.member;
        value = another(value, field.info);
        found |= changes(cloths[i].fabric(), fabric).stages;
        isSeen |= expectIncrementalIsFull(cloths[i], pictures[i], fabric);
      }
      EXPECT_EQ(found - Stage::label, field.info.stages - Stage::label) << "the table says otherwise";
      // A field of which no picture knows is a promise to the designer that is not kept; a label that changes the
      // picture draws other random numbers, or throws work away. Fibres know neither voxels nor estimators, and
      // estimators know no law.
      const std::string key = field.info.key;
      const bool fibres = GetParam().method == Method::fibres, plain = GetParam().estimator == Estimator::none;
      const bool idle =
          fibres ? key == "resolution" || key == "estimator" || key == "event_law" : key == "event_law" && !plain;
      EXPECT_EQ(isSeen, !field.info.stages.within(Stage::label) && !idle);
    });
  }
};

TEST_P(FieldStages, OfAFibre) {
  expectAllOf<Fibre>({blend(), blendByNumber()}, [](Fabric& fabric) -> Fibre& { return fabric.fibres[0]; });
}

/// Its second fibre is dyed by a recipe.
Fabric dyedBlend() {
  return blendWith([](Fabric& f) {
    Spectrum bands;
    bands.fill(10);
    f.fibres[1].absorption_per_mm = Absorption(bands);
    f.fibres[1].absorption_per_mm.dyes = {{"red", 2, bands}};
  });
}

TEST_P(FieldStages, OfABlendedFibre) {
  expectAllOf<Fibre>({blend(), blendByNumber(), dyedBlend()},
                     [](Fabric& fabric) -> Fibre& { return fabric.fibres[1]; });
}

TEST_P(FieldStages, OfADye) {
  expectAllOf<Dyestuff>({dyedBlend()},
                        [](Fabric& fabric) -> Dyestuff& { return fabric.fibres[1].absorption_per_mm.dyes[0]; });
}

TEST_P(FieldStages, OfAYarn) {
  const auto alike = [](Fabric& f) { f.fibres[1].radius_um = f.fibres[0].radius_um; };  // but for their colours
  expectAllOf<Yarn>({blend(), blendByNumber(), blendWith(alike)},
                    [](Fabric& fabric) -> Yarn& { return fabric.yarns[0]; });
}

TEST_P(FieldStages, OfTheDrape) {
  const test::ScratchFolder folder;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  std::ofstream(folder.file("cloth.obj")) << square << "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
  std::ofstream(folder.file("another cloth.obj")) << square << "f 1/1 2/2 3/3\n";
  const auto round = [](Fabric& f) { f.drape.kind = DrapeKind::cylinder, f.drape.radius_mm = 1; };
  const auto mesh = [&](Fabric& f) {
    f.drape.kind = DrapeKind::mesh;
    f.drape.file = folder.file("cloth.obj");
  };
  expectAllOf<Drape>({blend(), blendWith(round), blendWith(mesh)},
                     [](Fabric& fabric) -> Drape& { return fabric.drape; });
}

TEST_P(FieldStages, OfTheLight) {
  const test::ScratchFolder folder;
  Light sky;
  writeExr(folder.file("sky.exr"), test::surroundings(sky, 16));
  sky.azimuth_deg = 10;
  writeExr(folder.file("another sky.exr"), test::surroundings(sky, 16));
  std::filesystem::last_write_time(folder.file("another sky.exr"),
                                   std::filesystem::last_write_time(folder.file("sky.exr")));  // nothing tells of it
  const auto overcast = [](Fabric& f) { f.light.kind = LightKind::overcast; };
  const auto surrounded = [&](Fabric& f) {
    f.light.kind = LightKind::environment;
    f.light.file = folder.file("sky.exr");
  };
  std::ofstream(folder.file("lamp.txt")) << "380 1\n730 2\n";
  std::ofstream(folder.file("another lamp.txt")) << "380 2\n730 1\n";
  const auto measured = [&](Fabric& f) {
    f.light.illuminant = StandardIlluminant::file;
    f.light.illuminantFile = folder.file("lamp.txt");
  };
  expectAllOf<Light>({blend(), blendWith(overcast), blendWith(surrounded), blendWith(measured)},
                     [](Fabric& fabric) -> Light& { return fabric.light; });
}

TEST_P(FieldStages, OfTheCamera) {
  const auto lit = [](Fabric& f) { f.light.kind = LightKind::headlight; };
  expectAllOf<Camera>({blend(), blendWith(lit)}, [](Fabric& fabric) -> Camera& { return fabric.camera; });
}

TEST_P(FieldStages, OfTheRenderSettings) {
  expectAllOf<RenderSettings>({blend()}, [](Fabric& fabric) -> RenderSettings& { return fabric.render; });
}

TEST_P(FieldStages, OfTheFabric) {
  const auto cotton = [](Fabric& f) { f.fibres[0].section = FibreSection::kidney; };  // which mercerising acts on
  const auto rib = [](Fabric& f) { f.weave = Weave({{1, 1, 0, 0}, {0, 0, 1, 1}}); };  // whose threads may crowd
  expectAllOf<Fabric>({blend(), blendWith(cotton), blendWith(rib)}, [](Fabric& fabric) -> Fabric& { return fabric; });
}

TEST_P(FieldStages, OfWhatIsNoConstruction) {
  const auto noted = [](Fabric& f) {
    f.draft = Draft{};
    f.colourways.resize(1);
    WifOrigin origin;
    origin.yarns.resize(1);
    f.wif = std::make_shared<const WifOrigin>(origin);
  };
  const Cloth cloth = made(test::sceneOf(blendWith(noted)));
  const Picture picture = cloth.picture();
  const auto expectLabels = [&]<class Object>(const Object&, auto&& select) {
    forEachField<Object>([&](const auto& field) {
      Fabric fabric = cloth.fabric();
      Object& object = select(fabric);
      object.*field.member = another(object.*field.member, field.info);
      EXPECT_EQ(field.info.stages, Stages(Stage::label)) << field.info.key;
      const Changes change = changes(cloth.fabric(), fabric);
      EXPECT_FALSE(change.picture()) << field.info.key;
      const Cloth after = edited(cloth, fabric);
      expectMadeAgain(change, cloth, after);
      EXPECT_TRUE(after.picture() == picture) << field.info.key;
    });
  };
  expectLabels(Draft{}, [](Fabric& fabric) -> Draft& { return *fabric.draft; });
  expectLabels(MillData{}, [](Fabric& fabric) -> MillData& { return fabric.mill; });
  expectLabels(Colourway{}, [](Fabric& fabric) -> Colourway& { return fabric.colourways[0]; });
  const auto originOf = [](Fabric& fabric) -> WifOrigin& {
    const auto origin = std::make_shared<WifOrigin>(*fabric.wif);
    fabric.wif = origin;
    return *origin;
  };
  expectLabels(WifOrigin{}, originOf);
  expectLabels(WifYarn{}, [&](Fabric& fabric) -> WifYarn& { return originOf(fabric).yarns[0]; });
}

// The members of a fabric that are no plain fields.
TEST_P(FieldStages, OfListsAndTheWeave) {
  const Cloth cloth = made(test::sceneOf(blendWith([](Fabric& f) { GetParam().askFor(f); })));
  const Picture picture = cloth.picture();
  const auto isSeen = [&](auto&& edit) {
    Fabric fabric = cloth.fabric();
    edit(fabric);
    return expectIncrementalIsFull(cloth, picture, fabric);
  };
  EXPECT_TRUE(isSeen([](Fabric& f) { f.weave = f.weave.with(0, 0, !f.weave.at(0, 0)); }));
  EXPECT_TRUE(isSeen([](Fabric& f) { f.warpSequence = {0, 1}; }));
  EXPECT_TRUE(isSeen([](Fabric& f) { f.weftSequence = {1}; }));
  EXPECT_TRUE(isSeen([](Fabric& f) { f.yarns[1] = f.yarns[0], f.yarns[1].fibre = 2, f.warpSequence = {0, 1}; }));
  EXPECT_FALSE(isSeen([](Fabric& f) { f.warpSequence = {0, 0}; }));
  EXPECT_TRUE(isSeen([](Fabric& f) { f.warpSpacing = {1, 2}; }));
  EXPECT_TRUE(isSeen([](Fabric& f) { f.weftSpacing = {1, 1, 2}; }));
  EXPECT_FALSE(isSeen([](Fabric& f) { f.yarns.emplace_back(); }));
  EXPECT_FALSE(isSeen([](Fabric& f) { f.yarns.pop_back(); }));
  EXPECT_FALSE(isSeen([](Fabric& f) { f.fibres.emplace_back(); }));
}

INSTANTIATE_TEST_SUITE_P(Every, FieldStages,
                         testing::Values(test::kPlain, test::kReport, test::kLoomlight, test::kFibres),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace loomlight
