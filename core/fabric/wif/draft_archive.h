#pragma once

#include <string>
#include <string_view>

namespace loomlight {

/// Whether it is an archive (ZIP) by how it begins, as TempoWeave's .twa is one.
bool isDraftArchive(std::string_view bytes);

/// The weaving file in a .twa: WIF, as its entry `twamain.waf` ("TempoWeave WIF & TWA File Format Specification", 2.3,
/// 2026); how its parts were put together, pictures and what else an archive has is left in it. Throws InputError,
/// naming `source`, for an archive that is damaged, has a thousand files or more, no such entry, or one of more than
/// kMaxWifBytes.
std::string draftOfArchive(std::string_view bytes, const std::string& source);

}  // namespace loomlight
