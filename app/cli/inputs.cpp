#include "app/cli/inputs.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/export/file_name.h"
#include "app/export/picture.h"
#include "app/export/weave_bitmap.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/yarn/presets.h"

namespace loomlight {

namespace {

/// What was said of a draft, and which options would have taken more from it; what changes the cloth is said first.
FabricInput readDraft(const FabricSource& source) {
  const auto& [file, choices] = source;
  WifImport import = readWifFabric(file, plainCotton(), WifSizeChoice::keep);
  FabricInput input{std::move(import.fabric), {}};
  std::vector<WifWarning> warnings;
  const auto say = [&](std::string sentence) { warnings.push_back({std::move(sentence), {}}); };
  if (import.named != WifNamed{}) {
    Fabric cut = cutToNamed(input.fabric, import.named);
    const std::string size = fmt::format("{} ends and {} picks", cut.weave.ends(), cut.weave.picks());
    if (choices.threads == WifThreadChoice::named) {
      input.fabric = std::move(cut);
      say(fmt::format("Cut to the {} that are named.", size));
    } else {
      say(fmt::format("--wif-threads named cuts it to the {} that are named.", size));
    }
  }
  const bool keeps = choices.sizes == WifSizeChoice::keep;
  std::vector<WifWarning> sizes;
  if (keeps)
    sizes = otherWifSizes(input.fabric);
  else
    input.fabric = withWifSizes(std::move(input.fabric), sizes);
  warnings.insert(warnings.end(), sizes.begin(), sizes.end());
  if (keeps && !sizes.empty()) say("--wif-sizes file takes the file's sett and yarn counts.");
  warnings.insert(warnings.end(), import.warnings.begin(), import.warnings.end());
  sortByConcern(warnings);
  for (const WifWarning& warning : warnings) input.warnings.push_back(fmt::format("{}: {}", file, inOneLine(warning)));
  return input;
}

FabricInput withFileNamed(FabricReading reading, const std::string& file) {
  for (std::string& remark : reading.remarks) remark = fmt::format("{}: {}", file, remark);
  return {std::move(reading.fabric), std::move(reading.remarks)};
}

}  // namespace

FabricInput readInput(const FabricSource& source) {
  const std::string& file = source.file;
  const std::string extension = lowerExtension(file);
  if (isFabricFile(file)) return withFileNamed(openFabric(file), file);
  if (extension == ".exr") return {fabricOfPicture(file), {}};
  if (isWeavingFile(file)) return readDraft(source);
  if (extension == ".png") {
    Fabric fabric = plainCotton();
    fabric.name = std::filesystem::path(file).stem().string();
    fabric.weave = readWeaveBitmap(file);
    return {std::move(fabric), {}};
  }
  if (const auto program = programOfForeignDraft(file))
    throw InputError(
        fmt::format("{}: expected a draft in WIF, which {} can save; its own files are not read", file, *program));
  throw InputError(fmt::format(
      "{}: expected a fabric (.json, .loomlight), a draft (.wif, .plm, .dtx, .twa), a weave bitmap (.png) or a "
      "picture rendered by Loomlight (.exr)",
      file));
}

Fabric fabricFrom(const FabricSource& source) {
  FabricInput input = readInput(source);
  for (const std::string& warning : input.warnings) fmt::print(stderr, "{}\n", warning);
  return std::move(input.fabric);
}

}  // namespace loomlight
