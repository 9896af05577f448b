#include "app/editor/model/view_folder.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/choice_names.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

constexpr const char *kFabricKey = "loomlight.fabric", *kFlatKey = "loomlight.flat", *kSideKey = "loomlight.side",
                     *kLampKey = "loomlight.lamp";
constexpr const char* kBack = "back";
constexpr const char* kViewPrefix = "view-";  // what else lies in the folder is none of ours
constexpr const char* kExtension = ".png";

}  // namespace

ViewFolder::ViewFolder(fs::path folder, Budget budget) : folder_(std::move(folder)), budget_(budget) {}

std::string ViewFolder::newId() {
  using namespace std::chrono;
  const auto now_ns = duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
  return fmt::format("{}{:020}-{}", kViewPrefix, now_ns, getpid());
}

fs::path ViewFolder::fileOf(const std::string& id) const {
  return folder_ / (id + kExtension);
}

std::vector<std::string> ViewFolder::ids() const {
  std::vector<std::string> ids;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    const std::string id = it->path().stem().string();
    if (it->path().extension() == kExtension && id.starts_with(kViewPrefix)) ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

KeptView ViewFolder::read(const std::string& id) const {
  const std::string file = fileOf(id).string();
  std::map<std::string, std::string> texts;
  Pixels8 picture = readPng(file, &texts);
  const auto found = texts.find(kFabricKey);
  if (found == texts.end()) throw InputError(fmt::format(words::errors::noView, file));
  Fabric fabric = workingNames(fabricFromJson(found->second, file), file);
  KeptView view{id, std::make_shared<const Fabric>(std::move(fabric)), {}, std::move(picture)};
  if (const auto flat = texts.find(kFlatKey); flat != texts.end())
    view.lookedAt.flat = flatViewFromJson(flat->second, file);
  if (const auto side = texts.find(kSideKey); side != texts.end()) {
    if (side->second != kBack) throw InputError(fmt::format(words::errors::noSide, file, kSideKey, kBack));
    view.lookedAt.back = true;
  }
  if (const auto lamp = texts.find(kLampKey); lamp != texts.end()) {
    view.lookedAt.judgedUnder = choiceFromName<StandardIlluminant>(lamp->second);
    if (!view.lookedAt.judgedUnder) throw InputError(fmt::format(words::errors::noLamp, file, kLampKey, lamp->second));
  }
  if (view.picture.channels != 3) throw InputError(fmt::format(words::errors::viewWithAlpha, file));
  return view;
}

std::vector<std::string> ViewFolder::keep(const KeptView& view) const {
  const std::string file = fileOf(view.id).string();
  std::error_code error;
  fs::create_directories(folder_, error);  // where it cannot be made, writing says so
  std::map<std::string, std::string> texts{{kFabricKey, fabricToJson(localNames(*view.fabric, file))}};
  if (view.lookedAt.flat) texts[kFlatKey] = flatViewToJson(*view.lookedAt.flat);
  if (view.lookedAt.back) texts[kSideKey] = kBack;
  if (view.lookedAt.judgedUnder) texts[kLampKey] = choiceName(*view.lookedAt.judgedUnder);
  writePng(file, view.picture, texts);

  std::vector<std::string> kept = ids();
  std::reverse(kept.begin(), kept.end());
  std::vector<std::string> gone;
  uintmax_t bytes = 0;
  for (size_t i = 0; i < kept.size(); ++i) {
    const uintmax_t size = fs::file_size(fileOf(kept[i]), error);
    if (!error) bytes += size;
    if (kept[i] != view.id && (i >= budget_.views || bytes > budget_.bytes)) gone.push_back(kept[i]);
  }
  for (const std::string& id : gone) remove(id);
  return gone;
}

void ViewFolder::remove(const std::string& id) const {
  std::error_code ignored;
  fs::remove(fileOf(id), ignored);
}

}  // namespace loomlight
