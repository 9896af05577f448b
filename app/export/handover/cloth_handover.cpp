#include "app/export/handover/cloth_handover.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <utility>

#include "app/export/file_name.h"
#include "app/export/task_part.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/fabric/model/colourways.h"

namespace loomlight {
namespace {

/// A folder, made where there is none. One that was made and got no files goes again.
class FolderToFill {
 public:
  explicit FolderToFill(const std::string& folder) : folder_(folder) {
    std::error_code failed;
    made_ = std::filesystem::create_directories(folder, failed);
    if (failed)
      throw InputError(fmt::format("{}: expected a folder that can be made, got: {}", folder, failed.message()));
  }
  FolderToFill(const FolderToFill&) = delete;
  FolderToFill& operator=(const FolderToFill&) = delete;
  ~FolderToFill() {
    std::error_code refused;  // as it is for a folder that has anything in it
    if (made_) std::filesystem::remove(folder_, refused);
  }

 private:
  std::filesystem::path folder_;
  bool made_ = false;
};

/// All files are put in their places after minutes of tracing: what is in their way is better said before. Throws
/// InputError.
void expectRoomFor(const std::string& name, const std::filesystem::path& folder) {
  for (const std::string& file : handoverFiles(name)) {
    const std::filesystem::path path = folder / file;
    std::error_code ignored;
    const auto parent = std::filesystem::symlink_status(path.parent_path(), ignored);
    if (parent.type() != std::filesystem::file_type::not_found) expectWritable(path.string());
  }
}

}  // namespace

std::string handoverSidecar(const Fabric& fabric, const std::string& folder) {
  return (std::filesystem::path(folder) / (portableFileName(fabric.name) + ".handover.json")).string();
}

std::vector<HandoverPart> handoverParts(const Fabric& fabric, const std::string& folder, bool allColourways) {
  std::vector<HandoverPart> parts{{fabric, folder}};
  if (!allColourways) return parts;
  // The fabric's own textures have a folder beside these, and some file systems take capitals for small letters.
  std::set<std::string> taken{"textures"};
  for (const Colourway& colourway : fabric.colourways) {
    const std::string plain = portableFileName(colourway.name);
    std::string own = plain;
    for (int i = 2; !taken.insert(lowerCase(own)).second; ++i) own = fmt::format("{}_{}", plain, i);
    HandoverPart part{inColourway(fabric, colourway), (std::filesystem::path(folder) / own).string()};
    part.fabric.name += " " + colourway.name;
    parts.push_back(std::move(part));
  }
  return parts;
}

std::optional<HandoverReport> handOver(const HandoverPart& part, const DigitalClothOrder& order, double limit_bytes,
                                       const Task& task) {
  constexpr double kMade = 0.95;  // of the progress: the rest is writing
  const FolderToFill folder(part.folder);
  const std::string name = portableFileName(part.fabric.name);
  expectRoomFor(name, part.folder);
  const auto cloth = makeDigitalCloth(part.fabric, order, limit_bytes, partOf(task, 0, kMade));
  if (!cloth) return std::nullopt;
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  auto report = writeHandover(part.folder, name, *cloth, now, task);
  if (report) task.report(1);
  return report;
}

}  // namespace loomlight
