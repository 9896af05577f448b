#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {

/// Where a command finds its fabric, and how it reads it.
struct FabricSource {
  std::string file;  ///< of any kind that readInput() knows
  WifChoices wif;    ///< what is taken of a draft
};

struct FabricInput {
  Fabric fabric;
  std::vector<std::string> warnings;  ///< of an old file or a draft: "FILE: line 12: ..."
};

/// The fabric in a file of any kind that has one: a fabric (.json, .loomlight), a draft (.wif), a weave as a
/// black-and-white picture (.png), or a picture that we rendered (.exr). Drafts and weaves have the default yarns.
/// Throws InputError.
FabricInput readInput(const FabricSource& source);
/// The fabric that readInput() finds; its warnings go to stderr.
Fabric fabricFrom(const FabricSource& source);

}  // namespace loomlight
