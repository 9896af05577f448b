#include "render/transport/path_records.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kSide = 24;
constexpr uint32_t kRecordedSamples = 6;
constexpr size_t kPlenty = size_t{64} << 20;

/// Cotton crossed with silk, each with a dye of its own.
Fabric twoDyes(LightKind light) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 4;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.camera.distance_mm = 9;
  fabric.light.kind = light;
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].radius_um = 5;
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.weftSequence = {1};
  fabric.fibres[0].absorption_per_mm = Rgb(40, 8, 2);
  fabric.fibres[1].absorption_per_mm = Rgb(1, 30, 90);
  return fabric;
}

/// The same scene in other colours, its paths ending where those of the first do.
Scene dyed(Scene scene) {
  scene.colouring.primaries_per_mm = {Rgb(0.5f, 3, 25), Rgb(300, 0, 12)};
  return scene;
}

class Traced {
 public:
  explicit Traced(size_t bytes) : records(kSide, kSide, 2, bytes) {}
  Traced(const Scene& scene, const Medium& medium, size_t bytes) : Traced(bytes) {
    bringTo(kRecordedSamples, scene, medium);
  }
  void bringTo(uint32_t samples, const Scene& scene, const Medium& medium) {
    const CameraRays camera(scene.fabric->camera, kSide, kSide);
    renderUpTo(samples, scene, medium, camera, film, Task{}, {.records = &records});
  }
  Film film{kSide, kSide};
  PathRecords records;
};

PathRecords::Sums at(const std::vector<PathRecords::Sums>& picture, int x, int y) {
  return picture[static_cast<size_t>(y) * kSide + x];
}

void expectEqual(Rgb a, Rgb b) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(a[c], b[c], 1e-6f * b[c] + 2 * 0x1p-24f);  // the film's quantum, rounded twice
}

// Invariant: colour is nothing but exponentials of lengths. A picture made from records and one traced in the new
// colours are of the same paths, so they differ by rounding alone.
TEST(PathRecords, RecolouredIsWhatTheSamePathsTracedInTheNewColoursBring) {
  for (const LightKind light : {LightKind::dome, LightKind::sky, LightKind::headlight})
    for (const Estimator estimator : {Estimator::none, Estimator::loomlight}) {
      Fabric fabric = twoDyes(light);
      fabric.render.estimator = estimator;
      const auto scene = test::sceneOf(fabric);
      const auto medium = makeMedium(*scene, 1e9, Task{});
      const Traced first(*scene, *medium, kPlenty);
      const Scene other = dyed(*scene);
      const Traced second(other, *medium, kPlenty);
      const auto recoloured = first.records.recoloured({other.colouring, Rgb(1)}, 2);
      double change = 0;
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
          const PathRecords::Sums sums = at(recoloured, x, y);
          ASSERT_EQ(sums.samples, kRecordedSamples);
          expectEqual(sums.traced / float{kRecordedSamples}, first.film.mean(x, y));
          expectEqual(sums.recoloured / float{kRecordedSamples}, second.film.mean(x, y));
          change += glm::length(sums.recoloured - sums.traced);
        }
      EXPECT_GT(change, 10) << "the colours are others";
    }
}

// The same where a dye is known band by band, and seen under another lamp than the picture was traced under.
TEST(PathRecords, AreSeenByOtherLampsInBandsToo) {
  Fabric fabric = twoDyes(LightKind::sky);
  Spectrum bands;
  for (size_t j = 0; j < kBands; ++j) bands[j] = 20 + 20 * std::sin(static_cast<float>(j));
  fabric.fibres[0].absorption_per_mm = Absorption(bands);
  const auto scene = test::sceneOf(fabric);
  const auto medium = makeMedium(*scene, 1e9, Task{});
  const Traced first(*scene, *medium, kPlenty);
  Scene other = *scene;  // its paths end where they did
  fabric.light.illuminant = StandardIlluminant::f11;
  other.colouring = colouringOf(fabric);
  const Traced second(other, *medium, kPlenty);
  const auto recoloured = first.records.recoloured({other.colouring, Rgb(1)}, 2);
  double change = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const PathRecords::Sums sums = at(recoloured, x, y);
      expectEqual(sums.recoloured / float{kRecordedSamples}, second.film.mean(x, y));
      change += glm::length(sums.recoloured - sums.traced);
    }
  EXPECT_GT(change, 1) << "the lamp is another";
}

TEST(PathRecords, InItsOwnColoursIsTheFilm) {
  const auto scene = test::sceneOf(twoDyes(LightKind::sky));
  const auto medium = makeMedium(*scene, 1e9, Task{});
  const Traced traced(*scene, *medium, kPlenty);
  const auto same = traced.records.recoloured({scene->colouring, Rgb(1)}, 1);
  const auto half = traced.records.recoloured({scene->colouring, Rgb(0.5f)}, 1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      expectEqual(at(same, x, y).recoloured, at(same, x, y).traced);
      expectEqual(at(half, x, y).recoloured, 0.5f * at(same, x, y).recoloured);
    }
}

TEST(PathRecords, WithLittleRoomKeepTheFirstSamplesOfAllPixelsAlike) {
  const auto scene = test::sceneOf(twoDyes(LightKind::sky));
  const auto medium = makeMedium(*scene, 1e9, Task{});
  constexpr size_t kLittle = size_t{300} * kSide * kSide;
  Traced traced(kLittle);
  for (uint32_t samples = 1; samples <= kRecordedSamples; ++samples) {
    traced.bringTo(samples, *scene, *medium);
    EXPECT_LE(traced.records.bytes(), kLittle);
  }
  const uint32_t kept = traced.records.samples(0, 0);
  ASSERT_GT(kept, 0u);
  ASSERT_LT(kept, kRecordedSamples);
  const auto picture = traced.records.recoloured({scene->colouring, Rgb(1)}, 1);
  const CameraRays camera(scene->fabric->camera, kSide, kSide);
  TraceCounts counts;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      EXPECT_EQ(at(picture, x, y).samples, kept);
      Rgb first(0);
      for (uint32_t i = 0; i < kept; ++i) {
        const PathSample sample = tracePath(*scene, *medium, camera, x, y, i, counts);
        first += sample.direct + sample.indirect;
      }
      expectEqual(at(picture, x, y).recoloured, first);
    }
}

/// Bytes that the light of these samples of all pixels takes: 16 of each sample, and numbers of 4 bytes of each light.
size_t bytesNeeded(uint32_t samples, const Scene& scene, const Medium& medium) {
  const CameraRays camera(scene.fabric->camera, kSide, kSide);
  TraceCounts counts;
  size_t bytes = size_t{16} * samples * kSide * kSide;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (uint32_t i = 0; i < samples; ++i) {
        PathLog log;
        tracePath(scene, medium, camera, x, y, i, counts, &log);
        for (size_t light = 0; light < log.size(); ++light) {
          const LightColumns::Kind kind = LightColumns::kindOf(log.light(light), log.lengths_mm(light));
          const size_t ofAll = 4, ofFibre = 6,
                       ofLengths = 2;  // radiance and sample; modes, traverse, inside; materials
          bytes += 4 * (ofAll + (kind.material == PathLight::kNoFibre ? 0 : ofFibre) + (kind.isWithin ? ofLengths : 0));
        }
      }
  return bytes;
}

// No more is held in reserve than a quarter, and of each kind of a tile's lights a block that is not full.
TEST(PathRecords, KeepAsManySamplesAsThereIsRoomFor) {
  const auto scene = test::sceneOf(twoDyes(LightKind::sky));
  const auto medium = makeMedium(*scene, 1e9, Task{});
  constexpr uint32_t kWanted = 4;
  constexpr size_t kTiles = 4, kKinds = 6, kMostNumbers = 12;
  const size_t perTile = kKinds * (sizeof(LightColumns) + 4 * kMostNumbers * kWalkLanes);
  const size_t needed = bytesNeeded(kWanted, *scene, *medium);
  const auto brought = [&](size_t bytes, uint32_t samples) {
    Traced traced(bytes);
    for (uint32_t i = 1; i <= samples; ++i) traced.bringTo(i, *scene, *medium);
    return traced.records.recoloured({scene->colouring, Rgb(1)}, 1);
  };
  const auto kept = brought(needed * 5 / 4 + kTiles * perTile, kWanted);
  for (const PathRecords::Sums& sums : kept) ASSERT_EQ(sums.samples, kWanted);
  // Where there is room for one less, these are the same.
  const auto cut = brought(needed * 9 / 10, kWanted), whole = brought(kPlenty, kWanted - 1);
  for (size_t i = 0; i < cut.size(); ++i) {
    ASSERT_EQ(cut[i].samples, kWanted - 1);
    ASSERT_EQ(cut[i].recoloured, whole[i].recoloured);
    ASSERT_EQ(cut[i].traced, whole[i].traced);
  }
}

TEST(PathRecords, WithoutRoomForOneSampleKeepNone) {
  const auto scene = test::sceneOf(twoDyes(LightKind::sky));
  const auto medium = makeMedium(*scene, 1e9, Task{});
  const Traced traced(*scene, *medium, size_t{16} * kSide * kSide);
  EXPECT_EQ(traced.records.samples(kSide / 2, kSide / 2), 0u);
  EXPECT_EQ(traced.records.bytes(), 0u);
}

TEST(PathRecords, OfAPictureContinuedAreThoseOfOneRun) {
  const auto scene = test::sceneOf(twoDyes(LightKind::dome));
  const auto medium = makeMedium(*scene, 1e9, Task{});
  const Traced whole(*scene, *medium, kPlenty);
  Traced parts(kPlenty);
  for (const uint32_t samples : {1u, 4u, kRecordedSamples}) parts.bringTo(samples, *scene, *medium);
  const Recolouring recolouring{{{Rgb(3), Rgb(70)}}, Rgb(1)};
  const auto a = parts.records.recoloured(recolouring, 1), b = whole.records.recoloured(recolouring, 2);
  for (size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].recoloured, b[i].recoloured);
}

}  // namespace
}  // namespace loomlight
