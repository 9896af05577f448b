#include "app/cli/commands/bvdf_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/export/file_set.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/validate.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/bvdf/bvdf_picture.h"
#include "render/transport/yarn_names.h"

namespace loomlight {
namespace {

constexpr uint64_t kFullRays = 100'000'000;  // the report's table has 256 times the bins of ours

BvdfOptions bakeOptions(const BvdfCommand& command) {
  BvdfOptions options;
  if (command.full) {
    options.resolution = BvdfResolution::report();
    options.rays = kFullRays;
  }
  if (command.rays) options.rays = *command.rays;
  return options;
}

/// The tables' names, and what else is needed to make them again.
std::map<std::string, std::string> metadata(const Fabric& fabric, const std::vector<std::string>& names,
                                            const BvdfSet& set) {
  const BvdfResolution& r = set.tables.front().resolution();
  std::string yarns;
  for (size_t i = 0; i < names.size(); ++i)
    yarns += fmt::format("{}{}: {}.p", i ? ", " : "", names[i], set.tableOfYarn[i]);
  return {{"bvdf.bins", fmt::format("theta_o {}, phi_o {}, theta_i {}, phi_i {}", r.thetaO, r.phiO, r.thetaI, r.phiI)},
          {"bvdf.rays", std::to_string(set.rays)},
          {"bvdf.yarns", yarns},
          {"bvdf.fabric", fabricToJson(fabric)}};
}

/// Of tables it lies beside them.
std::filesystem::path pictureOf(const std::string& output) {
  std::filesystem::path picture = output;
  if (lowerExtension(output) == ".exr") picture.replace_extension(".png");
  return picture;
}

/// False when stopped, and then nothing is written.
bool write(const std::string& output, const Fabric& fabric, const BvdfSet& set, const Task& task) {
  const std::filesystem::path tables = output, picture = pictureOf(output);
  if (tables == picture) {
    writePng(output, bvdfPicture(set));
    return true;
  }
  const auto names = yarnNames(fabric, task);
  if (!names) return false;
  Image table = bvdfImage(set);
  table.metadata = metadata(fabric, *names, set);
  FileSet files(tables.parent_path().string(), tables.stem().string());
  writeExr(files.add(tables.filename().string()), table);
  writePng(files.add(picture.filename().string()), bvdfPicture(set));
  files.place();
  return true;
}

}  // namespace

int run(const BvdfCommand& command) {
  Stopwatch whole;
  const std::string extension = lowerExtension(command.output);
  if (extension != ".exr" && extension != ".png")
    throw InputError(fmt::format("{}: expected the name of tables (.exr) or of their picture (.png)", command.output));
  for (const std::string& file : {command.output, pictureOf(command.output).string()}) expectWritable(file);
  const Interrupt interrupt;
  const Fabric fabric = withOptions(fabricFrom(command.input), command.options, command.input.file);
  validate(fabric, command.input.file);
  std::shared_ptr<const BvdfSet> set;
  {
    Progress progress("baking local visibility");
    const Task task = progress.of(interrupt.task(command.threads));
    set = bakeBvdf(fabric, bakeOptions(command), BvdfCache(BvdfCache::userFolder()), task);
  }
  if (!set || !write(command.output, fabric, *set, interrupt.task(command.threads))) return Interrupt::kExitStatus;
  fmt::print("{}: {} table{} of {} rays, {}\n", command.output, set->tables.size(), set->tables.size() == 1 ? "" : "s",
             set->rays, durationText(whole.lap()));
  return 0;
}

}  // namespace loomlight
