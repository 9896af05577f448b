#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/wif/wif_warnings.h"

/// Between weaving files and fabrics. A fabric takes over the draft as it is, a yarn for each colour and thickness in
/// use, title and notes; what it does not hold it carries along as Fabric::wif.
namespace loomlight {

/// Sett and thickness of a weaving file are mostly the defaults of the program that wrote it, not those of a cloth.
enum class WifSizeChoice { keep, file };
template <>
struct ChoiceNames<WifSizeChoice> {
  static constexpr std::array names{"keep", "file"};
};

/// A file that states more threads than its lines name leaves the rest of the cloth empty; it may be cut off.
enum class WifThreadChoice { all, named };
template <>
struct ChoiceNames<WifThreadChoice> {
  static constexpr std::array names{"all", "named"};
};

/// What is taken from a weaving file.
struct WifChoices {
  WifSizeChoice sizes = WifSizeChoice::keep;
  WifThreadChoice threads = WifThreadChoice::all;
};

/// Sett and yarn as the file has them; nothing where it does not say.
struct WifSett {
  std::optional<double> ends_per_cm, picks_per_cm;
  std::optional<double> warpDiameter_mm, weftDiameter_mm;  ///< of the yarn that most threads have
};
/// For a dialog that asks which to use; all nothing for a fabric of another origin.
WifSett wifSett(const Fabric& fabric);

struct WifImport {
  Fabric fabric;
  std::vector<WifWarning> warnings;  ///< what was wrong in the file, and what was done: of most concern first
  WifNamed named = {};               ///< what cutToNamed() leaves
};

/// The fabric of a weaving file, valid. `mine` gives all that a weaving file does not: how the yarns are spun (the
/// first of its warp and of its weft), drape, light, camera; and with WifSizeChoice::keep the sett and the count of the
/// yarns. The file's colours dye them, and threads that are k times as thick as most get a yarn of k times the
/// diameter. Throws InputError, naming `source`, for what readWif() refuses.
WifImport fabricFromWif(std::string_view bytes, const std::string& source, const Fabric& mine, WifSizeChoice sizes);

/// The fabric with sett and yarn diameters of the weaving file it came from: what WifSizeChoice::file does, at any time
/// later. Says in `warnings` what the file asks for beyond the range of a fabric.
Fabric withWifSizes(Fabric fabric, std::vector<WifWarning>& warnings);
/// What the file says of sett and yarn where the fabric has others: for those who are not asked which to use.
std::vector<WifWarning> otherWifSizes(const Fabric& fabric);

/// The fabric with so many ends and picks only, from the first; 0 leaves a system as it is.
Fabric cutToNamed(Fabric fabric, WifNamed named);

struct WifExport {
  std::string text;
  std::vector<std::string> remarks;  ///< what is in the text otherwise than in the fabric
};
/// The fabric as a weaving file. One repeat of weave and colours together; a weave without a draft gets the smallest
/// one. Throws InputError, naming `file`, where that needs more shafts than a draft can have.
WifExport wifFromFabric(const Fabric& fabric, const std::string& file);

/// Read and write a weaving file on disk. Both throw InputError. A file is written whole or not at all; what is
/// returned are the remarks of WifExport.
WifImport readWifFabric(const std::string& file, const Fabric& mine, WifSizeChoice sizes);
std::vector<std::string> writeWifFabric(const Fabric& fabric, const std::string& file);

}  // namespace loomlight
