#include "app/editor/presets/preset_tags.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/export/file_name.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/json/json_text.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace fs = std::filesystem;

PresetTags::PresetTags(std::filesystem::path file) : file_(std::move(file)) {
  constexpr size_t kMostBytes = 4'000'000;
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file_, ignored))) return;
  try {
    tags_ = nlohmann::json::parse(readFile(file_.string(), kMostBytes)).get<std::map<std::string, std::string>>();
  } catch (const InputError& error) {
    problem_ = error.what();
  } catch (const nlohmann::json::exception&) {
    problem_ = fmt::format(words::errors::noTags, file_.string());
  }
  if (!problem_.empty()) problem_ = fmt::format(words::errors::tagsGoElsewhere, problem_);
}

/// What cannot be read now may be read again by hand, or by a newer version.
void PresetTags::putAside() {
  if (problem_.empty()) return;
  std::error_code error;
  // Whatever is there: writing could not replace a folder, and would end where a link leads.
  if (!fs::exists(fs::symlink_status(file_, error))) return problem_.clear();
  fs::rename(file_, freeFile(file_.string() + ".unreadable"), error);
  if (error) throw InputError(fmt::format(words::errors::notPutAside, file_.string(), error.message()));
  problem_.clear();
}

std::string PresetTags::of(const std::string& preset) const {
  const auto found = tags_.find(preset);
  return found == tags_.end() ? std::string() : found->second;
}

void PresetTags::set(const std::string& preset, const std::string& tags) {
  auto changed = tags_;
  if (tags.empty())
    changed.erase(preset);
  else
    changed[preset] = tags;
  std::error_code ignored;  // where the folder cannot be made, writing says so
  fs::create_directories(file_.parent_path(), ignored);
  // Names of files may be no UTF-8.
  const std::string text = jsonText(nlohmann::json(changed), 2);
  putAside();
  writeFileAtomically(file_.string(), text + "\n");
  tags_ = std::move(changed);
}

}  // namespace loomlight
