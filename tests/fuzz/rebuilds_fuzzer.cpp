#include "core/volume/traverse/cloth_volume.h"
#include "tests/fuzz/choices.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"
#include "tests/unit/volume/volume_fixture.h"

namespace loomlight::fuzz {
namespace {

using volume_test::geometryOf;

constexpr int kMostRebuilds = 4;

/// Small, of a handful of fibres: it is the maps that this is about.
Fabric fewFibres() {
  Fabric fabric = volume_test::hairyTwill();
  fabric.fibres[0].radius_um = 100;
  fabric.yarns[0].hairiness_per_mm = 0.3;  // one or two, so that milling acts
  return fabric;
}

Fabric reshaped(Fabric fabric, Choices& choices) {
  Yarn& yarn = fabric.yarns[choices.below(2)];
  const auto sequence = [&choices] {
    std::vector<int> yarns(static_cast<size_t>(choices.from(1, 4)));
    for (int& index : yarns) index = choices.from(0, 1);
    return yarns;
  };
  switch (choices.below(16)) {
    case 0:
      fabric.weave = fabric.weave.resized(choices.from(1, 12), choices.from(1, 12));
      break;
    case 1:
      yarn.plyTwist_per_m = 100.0 * choices.from(0, 8);
      break;
    case 2:
      yarn.plies = choices.from(1, 3);
      break;
    case 3:
      yarn.count_tex = 5.0 * choices.from(4, 10);
      break;
    case 4:
      fabric.ends_per_cm = choices.from(18, 26);
      break;
    case 5:
      fabric.picks_per_cm = choices.from(18, 26);
      break;
    case 6:
      fabric.warpSequence = sequence();
      break;
    case 7:
      fabric.weftSequence = sequence();
      break;
    case 8:
      std::swap(fabric.yarns[0], fabric.yarns[1]);
      break;
    case 9:
      fabric.press = 0.25 * choices.from(0, 4);
      break;
    case 10:
      fabric.milling = 0.25 * choices.from(0, 4);
      break;
    case 11:
      fabric.settCv_percent = 5.0 * choices.from(0, 4);
      break;
    case 12:
      fabric.crowding = choices.from(0, 3);
      break;
    case 13: {
      std::vector<double>& spacing = choices.from(0, 1) ? fabric.warpSpacing : fabric.weftSpacing;
      spacing.resize(static_cast<size_t>(choices.from(0, 3)));
      for (double& distance : spacing) distance = choices.from(1, 3);
      break;
    }
    default: {
      const int pick = choices.from(0, fabric.weave.picks() - 1), end = choices.from(0, fabric.weave.ends() - 1);
      fabric.weave = fabric.weave.with(pick, end, !fabric.weave.at(pick, end));
    }
  }
  return fabric;
}

}  // namespace

void fuzzRebuilds(std::string_view bytes) {
  Choices choices(bytes);
  Task one;
  one.threads = 1;  // for volumes this small, to wake another takes longer than to do its work
  Fabric fabric = fewFibres(), before = fabric;
  int ends = choices.from(1, 12), picks = choices.from(1, 12);
  auto geometry = geometryOf(fabric, ends, picks);
  auto volume = ClothVolume::build(geometry, 1, one);
  for (int step = 0; step < kMostRebuilds && !choices.isOver(); ++step) {
    if (choices.below(8) == 0) {
      std::swap(fabric, before);  // undone, or done again
    } else {
      before = fabric;
      fabric = reshaped(std::move(fabric), choices);
    }
    if (choices.below(8) == 0) {  // a piece of another size
      ends = choices.from(1, 16);
      picks = choices.from(1, 16);
    }
    geometry = std::make_shared<const ClothGeometry>(fabric, ends, picks, geometry.get());
    volume = ClothVolume::build(geometry, 1, one, volume.get());
    expect(volume_test::sameVolume(*ClothVolume::build(geometryOf(fabric, ends, picks), 1, one), *volume),
           fmt::format("after step {} the volume is not what is made from nothing", step));
  }
}

}  // namespace loomlight::fuzz
