#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {

struct FabricInput {
  Fabric fabric;
  std::vector<std::string> warnings;  ///< of a weaving file: "FILE: line 12: ..."
};

/// The fabric in a file of any kind that has one: a fabric (.json, .loomlight), a draft (.wif), a weave as a
/// black-and-white picture (.png), or a picture that we rendered (.exr). Drafts and weaves have the default yarns;
/// `choices` says what is taken from a draft. Throws InputError.
FabricInput readInput(const std::string& file, const WifChoices& choices = {});
/// The fabric that readInput() finds; its warnings go to stderr.
Fabric fabricFromFile(const std::string& file, const WifChoices& choices = {});

}  // namespace loomlight
