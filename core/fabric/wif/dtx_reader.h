#pragma once

#include <string>
#include <string_view>

#include "core/fabric/model/wif_document.h"
#include "core/fabric/wif/wif_warnings.h"

namespace loomlight {

/// Whether it is a draft in the text format of Fiberworks, .dtx, by how it begins.
bool isDtx(std::string_view bytes);

/// Reads such a draft as the weaving file that says the same. Its maker has not published the format: this is as its
/// files are, and as others have described them (dtx_to_wif). Throws InputError, naming `source`, for what holds no
/// draft, or one larger than a Weave can be or a loom can make; whatever else is wrong is in `warnings`.
WifDocument readDtx(std::string_view bytes, const std::string& source, WifWarnings& warnings);

}  // namespace loomlight
