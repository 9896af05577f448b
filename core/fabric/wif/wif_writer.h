#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/wif_document.h"

namespace loomlight {

/// A weaving file as WIF 1.1 wants it, strictly: all required sections and keys, the constants of the specification,
/// every section listed in [CONTENTS], every thread with a line of its own, lines that end in CR LF. ASCII, unless the
/// document's texts are not: then UTF-8. readWif() gives the same document back, without a warning.
///
/// Only `document.program` is not written, for the program that writes the file is this one; and of kept lines about
/// single threads those that name a thread the draft does not have.
std::string wifFromDocument(const WifDocument& document);

/// The lines that hold `rest`, in the same syntax, and nothing else: how a fabric's own file carries it.
/// readWifRest() gives the same back.
std::vector<std::string> wifRestLines(const WifRest& rest);

}  // namespace loomlight
