#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/fabric/weave/structures.h"

namespace loomlight {

/// The structures that weavers know by name, each with the numbers that vary it.

struct StructureParameter {
  const char* name;
  const char* meaning;
  int min, max, start;
  std::span<const char* const> choices = {};  ///< names of min.. max, where it is no number
};

struct MadeStructure {
  std::string name;  ///< with its numbers, as weavers write it: "Twill 3/1 Z", "Satin 8, move 3"
  Weave weave;
  /// Of a colour-and-weave effect: 0 the dark yarn, 1 the light one, along ends and picks; else empty.
  std::vector<int> warpColours, weftColours;
  std::string problem;  ///< why these numbers make no such structure; the weave is then plain
};

struct StructureKind {
  const char* name;
  const char* about;
  std::vector<StructureParameter> parameters;
  /// One value for each parameter, within its range.
  MadeStructure (*make)(const std::vector<int>& values);

  std::vector<int> startValues() const;
};

/// All kinds, simple ones first.
const std::vector<StructureKind>& structureLibrary();

/// What a single layer of crossings cannot say, and so is not offered.
const char* unwovenStructures();

}  // namespace loomlight
