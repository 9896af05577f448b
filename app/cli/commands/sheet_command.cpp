#include "app/cli/commands/sheet_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/part_names.h"
#include "app/cli/progress.h"
#include "app/cli/swatches.h"
#include "core/base/stopwatch.h"

namespace loomlight {
namespace {

std::vector<ClothStandard> standardsOf(const SheetCommand& command, const Fabric& fabric) {
  std::vector<ClothStandard> standards;
  for (const std::string& text : command.standards) {
    const StandardChoice choice = standardChoice(text);
    ClothStandard& standard = standards.emplace_back();
    if (!choice.part.empty())
      standard.part =
          partNamed(choice.part, fabric, NamedParts::yarnsAndFibres, fmt::format("{}: --standard", command.input.file));
    standard.partName = standard.part == wholePiece() ? "Cloth" : partText(standard.part, fabric);
    const MeasuredSwatch swatch = swatchFrom(choice.swatch);
    standard.name = swatch.name;
    if (const std::string_view specularly = specularText(swatch.specular); !specularly.empty())
      standard.name += fmt::format(" ({})", specularly.substr(0, specularly.find(',')));
    standard.reflectance = bandReflectance(swatch);
  }
  return standards;
}

}  // namespace

StandardChoice standardChoice(const std::string& text) {
  const auto isThere = [](const std::string& swatch) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(swatchChoice(swatch).file, ignored);
  };
  if (isThere(text)) return {"", text};
  const size_t last = text.rfind('=');
  for (size_t at = last; at != std::string::npos && at > 0; at = text.rfind('=', at - 1))
    if (isThere(text.substr(at + 1))) return {text.substr(0, at), text.substr(at + 1)};
  if (last == std::string::npos) return {"", text};  // who opens it says that it is missing
  return {text.substr(0, last), text.substr(last + 1)};
}

int run(const SheetCommand& command) {
  Stopwatch whole;
  const Fabric fabric = fabricFrom(command.input);
  ClothSheetOptions options = command.options;
  options.standards = standardsOf(command, fabric);
  const Interrupt interrupt;
  Progress progress("rendering the cloth");
  const Task task = progress.of(interrupt.task(command.threads));
  const auto write = command.colourways ? writeColourwaySheet : writeClothSheet;
  if (!write(command.output, fabric, options, task)) return Interrupt::kExitStatus;
  fmt::print("{}, {}\n", command.output, durationText(whole.lap()));
  return 0;
}

}  // namespace loomlight
