#include "app/editor/preset_tags.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"

namespace loomlight {

PresetTags::PresetTags(std::filesystem::path file) : file_(std::move(file)) {
  constexpr size_t kMostBytes = 4'000'000;
  try {
    tags_ = nlohmann::json::parse(readFile(file_.string(), kMostBytes)).get<std::map<std::string, std::string>>();
  } catch (const InputError&) {
    return;
  } catch (const nlohmann::json::exception&) {
    return;
  }
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
  std::filesystem::create_directories(file_.parent_path(), ignored);
  // Names of files may be no UTF-8.
  const std::string text = nlohmann::json(changed).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
  writeFileAtomically(file_.string(), text + "\n");
  tags_ = std::move(changed);
}

}  // namespace loomlight
