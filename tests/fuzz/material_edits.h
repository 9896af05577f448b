#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/fabric/model/colourways.h"
#include "core/fabric/weave/yarn_order.h"
#include "core/fabric/yarn/colour.h"
#include "core/fabric/yarn/dyeing.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "tests/fuzz/field_edits.h"
#include "tests/fuzz/finding.h"

namespace loomlight::fuzz {

/// What an edit makes of a fabric, and what the editor promises of it.
struct Edited {
  Fabric fabric;
  std::optional<Stages> stages = {};  ///< that it may put out of date; any where not given
  /// Whether two numbers that are each in their range may not go together: the editor then says so, and keeps the
  /// fabric as it was.
  bool mayBeRefused = false;
};

inline constexpr int kMostYarns = 8, kMostFibres = 16, kMostColourways = 4, kLongestOrder = 6;

/// All that dyeing may put out of date: no voxel, and no path but for fibres that are new.
inline Stages ofDyes() {
  return Stage::colour | Stage::optics | Stage::label;
}

template <class Presets>
const auto& oneOf(const Presets& presets, Choices& choices) {
  return presets[choices.below(static_cast<uint32_t>(presets.size()))];
}

/// One row of the yarn's page. Its fibres are chosen from a list of those that are there.
inline Edited withYarnField(Fabric fabric, int index, Choices& choices) {
  Yarn& yarn = fabric.yarns[static_cast<size_t>(index)];
  const Stages stages = editOneField(yarn, choices);
  const int fibres = static_cast<int>(fabric.fibres.size());
  yarn.fibre %= fibres;
  if (yarn.blendFibre) *yarn.blendFibre %= fibres;
  return {std::move(fabric), stages, true};
}

/// The order of yarns along the warp or the weft, as it is typed.
inline Edited withYarnOrder(Fabric fabric, Choices& choices) {
  const int yarns = static_cast<int>(fabric.yarns.size());
  std::vector<int> order(static_cast<size_t>(choices.from(1, kLongestOrder)));
  for (int& yarn : order) yarn = choices.from(0, yarns - 1);
  const std::vector<int> read = yarnOrderFromText(yarnOrderText(order), yarns, kLongestOrder);
  expect(read == order, "an order of yarns is read as another");
  (choices.below(2) ? fabric.warpSequence : fabric.weftSequence) = read;
  return {std::move(fabric), Stage::thread | Stage::shape, false};
}

inline Edited withOtherYarns(const Fabric& fabric, Choices& choices) {
  const int count = static_cast<int>(fabric.yarns.size()), index = choices.from(0, count - 1);
  switch (choices.below(6)) {
    case 0: {
      if (count == kMostYarns || fabric.fibres.size() >= kMostFibres) return {fabric};
      Edited copied{withYarnCopied(fabric, index), ofDyes()};
      expect(!isWoven(copied.fabric, count), "a yarn that was copied is woven already");
      return copied;
    }
    case 1:
      if (count == 1 || isWoven(fabric, index)) return {fabric};
      return {withoutYarn(fabric, index)};
    case 2: {
      const YarnPreset preset = oneOf(yarnPresets(), choices);
      const Yarn& yarn = fabric.yarns[static_cast<size_t>(index)];
      const Fibre& old = fabric.fibres[static_cast<size_t>(yarn.fibre)];
      return {withYarn(fabric, index, preset.yarn, dyedLike(preset.fibre, old))};
    }
    case 3:
      return withYarnOrder(fabric, choices);
    default:
      return withYarnField(fabric, index, choices);
  }
}

inline Edited withOtherFibres(Fabric fabric, Choices& choices) {
  const int index = choices.from(0, static_cast<int>(fabric.fibres.size()) - 1);
  Fibre& fibre = fabric.fibres[static_cast<size_t>(index)];
  switch (choices.below(4)) {
    case 0: {
      const int yarn = choices.from(0, static_cast<int>(fabric.yarns.size()) - 1);
      const Fibre kind = dyedLike(oneOf(fibrePresets(), choices).fibre, fibre);
      return {withFibre(std::move(fabric), yarn, kind), std::nullopt, true};
    }
    case 1:
      if (fabric.fibres.size() < kMostFibres) addFibre(fabric, Fibre(fibre), index);
      return {std::move(fabric), ofDyes()};
    default: {
      const Stages stages = editOneField(fibre, choices);
      return {std::move(fabric), stages, true};
    }
  }
}

inline ClothPart partOf(const Fabric& fabric, Choices& choices) {
  switch (choices.below(3)) {
    case 0:
      return wholePiece();
    case 1:
      return partOfYarn(choices.from(0, static_cast<int>(fabric.yarns.size()) - 1));
    default:
      return partOfFibre(choices.from(0, static_cast<int>(fabric.fibres.size()) - 1));
  }
}

inline Edited withOtherColours(Fabric fabric, Choices& choices) {
  switch (choices.below(4)) {
    case 0:
      if (fabric.colourways.size() < kMostColourways) fabric.colourways.push_back(colourwayOf(fabric, "Rust"));
      return {std::move(fabric), Stage::label};
    case 1: {
      if (fabric.colourways.empty()) return {std::move(fabric)};
      const Colourway chosen = oneOf(fabric.colourways, choices);
      return {inColourway(std::move(fabric), chosen), ofDyes()};
    }
    case 2: {
      const size_t index = choices.below(static_cast<uint32_t>(fabric.fibres.size()));
      const Rgb colour = colourIn(FieldInfo{{}, "", "", "", 0, 1}, choices);
      fabric.fibres[index] = dyed(std::move(fabric.fibres[index]), colour);
      return {std::move(fabric), ofDyes()};
    }
    default: {
      if (fabric.fibres.size() >= kMostFibres) return {std::move(fabric)};
      const ClothPart part = partOf(fabric, choices);
      Absorption absorption;
      choose(absorption, fieldInfo(&Fibre::absorption_per_mm), choices);
      Fabric dyed = dyedAlike(readyToDye(std::move(fabric), part), part, absorption);
      for (const int fibre : fibresOf(dyed, part))
        expect(dyed.fibres[static_cast<size_t>(fibre)].absorption_per_mm == absorption, "a part is not dyed");
      return {std::move(dyed), ofDyes()};
    }
  }
}

/// What the cloth lies on, what shines on it, and how it is finished.
inline Edited withOtherScene(Fabric fabric, Choices& choices) {
  switch (choices.below(3)) {
    case 0: {
      const Stages stages = editOneField(fabric.light, choices);
      return {std::move(fabric), stages, true};
    }
    case 1: {
      const Stages stages = editOneField(fabric.drape, choices);
      return {std::move(fabric), stages, true};
    }
    default: {
      const Stages stages = editOneField(fabric, choices);
      return {std::move(fabric), stages, true};
    }
  }
}

}  // namespace loomlight::fuzz
