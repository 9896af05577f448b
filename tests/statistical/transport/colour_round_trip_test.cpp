/// From a measured swatch to the fibre and back: dyes are solved for a cloth, the cloth is rendered with them, and what
/// the render shows is held against what was asked for.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/fabric/weave/structures.h"
#include "render/colour/illuminants.h"
#include "render/colour/tristimulus.h"
#include "render/transport/colour_solver.h"
#include "render/transport/dye_paths.h"
#include "render/transport/path_records.h"
#include "tests/statistical/transport/rendered_colour.h"

namespace loomlight {
namespace {

struct Construction {
  std::string name;
  Weave weave;
  double ends_per_cm, picks_per_cm, count_tex, fibreRadius_um, twist_per_m;
};

const std::array<Construction, 4>& constructions() {
  static const std::array<Construction, 4> kAll = {Construction{"poplin", plainWeave(), 40, 28, 15, 6.5, 900},
                                                   Construction{"flannel", twill(2, 2), 22, 20, 50, 10, 400},
                                                   Construction{"satin", satin(5, 2), 60, 40, 8, 5, 150},
                                                   Construction{"voile", plainWeave(), 20, 18, 8, 6.5, 1200}};
  return kAll;
}

/// All of one fibre, which does not absorb.
Fabric undyed(const Construction& of) {
  Fabric fabric = test::whiteCotton();
  fabric.weave = of.weave;
  fabric.ends_per_cm = of.ends_per_cm;
  fabric.picks_per_cm = of.picks_per_cm;
  fabric.yarns[0].count_tex = of.count_tex;
  fabric.yarns[0].plyTwist_per_m = of.twist_per_m;
  fabric.fibres[0].radius_um = of.fibreRadius_um;
  fabric.render.resolution = 4;
  return fabric;
}

Spectrum flatSpectrum(double value) {
  Spectrum bands;
  bands.fill(static_cast<float>(value));
  return bands;
}

PathLengthTally walksOf(const Fabric& fabric, double error) {
  const PatchOfCloth patch(fabric);
  auto paths = tracePathsForDyes(*patch.scene, *patch.medium, partOfFibre(0), Task{}, DyePaths::toSolve, error);
  EXPECT_TRUE(paths.has_value());
  return paths.value_or(PathLengthTally{});
}

/// A picture of the middle of the cloth from straight above, of paths that can be seen in any dye.
class Picture {
 public:
  explicit Picture(Fabric fabric) {
    fabric.render.seed += 1;
    fabric.camera.elevation_deg = 90;
    fabric.camera.fov_deg = 0;
    fabric.camera.distance_mm = 20;
    const PatchOfCloth patch(fabric);
    renderUpTo(kSamples, *patch.scene, *patch.medium, CameraRays(fabric.camera, kSide, kSide), film_, Task{},
               {.window = kMiddle, .records = &records_});
  }
  /// Of what is cloth, linear.
  Rgb mean(const Colouring& dyed) const {
    const std::vector<PathRecords::Sums> picture = records_.recoloured({dyed, Rgb(1)}, 2);
    glm::dvec3 sum(0.0);
    double covered = 0;
    for (int y = kMiddle.y; y < kMiddle.y + kMiddle.height; ++y)
      for (int x = kMiddle.x; x < kMiddle.x + kMiddle.width; ++x) {
        sum += glm::dvec3(picture[static_cast<size_t>(y) * kSide + static_cast<size_t>(x)].recoloured);
        covered += static_cast<double>(film_.alpha(x, y)) * kSamples;
      }
    return Rgb(sum / covered);
  }

 private:
  static constexpr int kSide = 128;
  static constexpr uint32_t kSamples = 48;
  static constexpr PixelRect kMiddle{kSide / 4, kSide / 4, kSide / 2, kSide / 2};
  Film film_{kSide, kSide};
  PathRecords records_{kSide, kSide, 1, size_t{256} << 20};
};

/// Eight hues by three depths: hills and valleys of reflectance as shares of what the undyed cloth reflects.
std::vector<Spectrum> swatchesBelow(const Spectrum& undyed) {
  std::vector<Spectrum> swatches;
  for (int hue = 0; hue < 8; ++hue)
    for (const double depth : {0.75, 0.4, 0.2}) {
      Spectrum swatch;
      for (size_t j = 0; j < kBands; ++j) {
        const double away = (bandWavelength_nm(j) - (420 + 38 * hue)) / 70.0;
        const double hill = std::exp(-away * away);
        swatch[j] = static_cast<float>(undyed[j] * depth * (0.35 + 0.6 * (hue % 2 ? 1 - hill : hill)));
      }
      swatches.push_back(swatch);
    }
  return swatches;
}

TristimulusWeights inDaylight() {
  return tristimulusWeights(illuminantNamed("D65"), Observer::degrees10);
}

class ColourRoundTrip : public testing::TestWithParam<Construction> {};

/// The picture is of other paths than the solution: both have their noise. The tally's standard error is kDyeError at
/// the worst of colours; of the picture's samples, as many as its paths or more, it is no larger. So 0.5 is at
/// least 2.3 of their standard errors together, of the darkest colours; of most it is far more.
TEST_P(ColourRoundTrip, AMeasuredSwatchIsWhatThePictureShows) {
  const Fabric fabric = undyed(GetParam());
  const PathLengthTally paths = walksOf(fabric, kDyeError);
  const Picture picture(fabric);
  const Colouring white = colouringInDaylight(fabric);
  const LinearWeights daylight = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  for (const Spectrum& swatch : swatchesBelow(paths.reflectance(white).mean)) {
    constexpr std::array<int, 1> kFirst = {0};
    const SolvedReflectance solved = solveReflectance(paths, white, kFirst, swatch, inDaylight());
    EXPECT_EQ(solved.tooLight, 0u);
    if (solved.tooDark > 0) continue;  // darker than what the surfaces of these fibres mirror
    Colouring dyed = white;
    dyed.setBands(0, solved.absorption_per_mm);
    const double difference = colourDifference(picture.mean(dyed), Rgb(weighted(daylight, swatch)));
    EXPECT_LT(difference, 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Constructions, ColourRoundTrip, testing::ValuesIn(constructions()),
                         [](const auto& info) { return info.param.name; });

/// Kubelka and Munk's K/S = (1 - R)^2 / 2R of dyed less that of undyed cloth grows in proportion to the dye on the
/// fibre: dyers reckon with it, and know that it holds up to medium depths, where light from the surface of the fibres
/// begins to count. Over this range the dye is 32 times as much; a law in the logarithm of R instead grows 5 times
/// here.
TEST(ColourOfDyedCloth, KubelkaMunkIsInProportionToTheDye) {
  const Fabric fabric = undyed(constructions()[1]);
  const PathLengthTally paths = walksOf(fabric, kToldError);
  const auto strength = [&](double absorption_per_mm) {
    Colouring dyed = colouringInDaylight(fabric);
    dyed.setBands(0, flatSpectrum(absorption_per_mm));
    const double R = paths.reflectance(dyed).mean[10];
    return (1 - R) * (1 - R) / (2 * R);
  };
  const double ground = strength(0);
  for (double a = 0.5; a < 16; a *= 2) {
    const double doubling = (strength(2 * a) - ground) / (strength(a) - ground);
    EXPECT_NEAR(doubling, 2, 0.3) << a << " per mm";
  }
}

}  // namespace
}  // namespace loomlight
