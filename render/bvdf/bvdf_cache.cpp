#include "render/bvdf/bvdf_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>

#include "core/base/checksum.h"
#include "core/base/error.h"
#include "core/base/file.h"

// How it works. The tables of one recipe are one file, named by the recipe's checksum: a line that says what it is,
// the recipe itself with its length, how many rays were traced, the tables with their resolutions, hot spots and
// ratios, and a checksum of all that, in the processor's order of bytes. A file counts only where checksum and
// recipe agree and every number is plausible; else the tables are baked again. A file's time of modification says
// when it was used last: beyond so many bytes those go that were used longest ago. Programs may share the folder, as
// files are replaced whole and one that has gone is no error. Cost: reading and writing are linear in bytes.

namespace loomlight {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "loomlight bvdf 1\n";
constexpr std::string_view kExtension = ".bvdf";
constexpr size_t kMaxFileBytes = size_t{1} << 30;
constexpr uint32_t kMaxTables = 64, kMaxSide = 256;

template <class T>
void append(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Takes values off the front of bytes; once there are too few it stays failed.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  bool take(void* to, size_t size) {
    if (failed_ || size > bytes_.size()) return !(failed_ = true);
    std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
    return true;
  }
  template <class T>
  T take() {
    T value{};
    take(&value, sizeof(T));
    return value;
  }
  bool takeText(std::string_view expected) {
    failed_ |= !bytes_.starts_with(expected);
    if (!failed_) bytes_.remove_prefix(expected.size());
    return !failed_;
  }
  size_t left() const { return bytes_.size(); }
  bool failed() const { return failed_; }

 private:
  std::string_view bytes_;
  bool failed_ = false;
};

std::string encode(const std::string& recipe, const BvdfSet& set) {
  std::string bytes(kMagic);
  append(bytes, static_cast<uint64_t>(recipe.size()));
  bytes += recipe;
  append(bytes, set.rays);
  append(bytes, static_cast<uint32_t>(set.tables.size()));
  for (const Bvdf& table : set.tables) {
    append(bytes, table.resolution());
    append(bytes, table.hotSpot());
    bytes.append(reinterpret_cast<const char*>(table.ratios().data()), table.ratios().size_bytes());
  }
  append(bytes, checksum(bytes));
  return bytes;
}

bool plausible(const BvdfResolution& r) {
  for (const int side : {r.thetaO, r.phiO, r.thetaI, r.phiI})
    if (side < 1 || side > static_cast<int>(kMaxSide)) return false;
  return r.phiI % 2 == 0;
}

std::optional<BvdfSet> decode(std::string_view bytes, const std::string& recipe) {
  if (bytes.size() < sizeof(uint64_t)) return std::nullopt;
  uint64_t sum = 0;
  std::memcpy(&sum, bytes.data() + bytes.size() - sizeof(sum), sizeof(sum));
  bytes.remove_suffix(sizeof(sum));
  if (sum != checksum(bytes)) return std::nullopt;

  Reader reader(bytes);
  if (!reader.takeText(kMagic) || reader.take<uint64_t>() != recipe.size() || !reader.takeText(recipe))
    return std::nullopt;
  BvdfSet set;
  set.rays = reader.take<uint64_t>();
  const auto count = reader.take<uint32_t>();
  if (count < 1 || count > kMaxTables) return std::nullopt;
  for (uint32_t i = 0; i < count; ++i) {
    const auto resolution = reader.take<BvdfResolution>();
    const auto hotSpot = reader.take<HotSpot>();
    if (!plausible(resolution) || resolution.bins() * sizeof(float) > reader.left()) return std::nullopt;
    std::vector<float> ratios(resolution.bins());
    reader.take(ratios.data(), ratios.size() * sizeof(float));
    if (!std::all_of(ratios.begin(), ratios.end(), [](float q) { return std::isfinite(q) && q >= 0; }))
      return std::nullopt;
    set.tables.emplace_back(resolution, hotSpot, std::move(ratios));
  }
  if (reader.failed() || reader.left() != 0) return std::nullopt;
  return set;
}

}  // namespace

fs::path BvdfCache::userFolder() {
  const auto absolute = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value == '/' ? fs::path(value) : fs::path();
  };
  if (const fs::path cache = absolute("XDG_CACHE_HOME"); !cache.empty()) return cache / "loomlight" / "bvdf";
  if (const fs::path home = absolute("HOME"); !home.empty()) return home / ".cache" / "loomlight" / "bvdf";
  return {};
}

fs::path BvdfCache::fileOf(const std::string& recipe) const {
  return folder_ / fmt::format("{:016x}{}", checksum(recipe), kExtension);
}

bool BvdfCache::has(const std::string& recipe) const {
  std::error_code ignored;
  return !folder_.empty() && fs::is_regular_file(fileOf(recipe), ignored);
}

std::optional<BvdfSet> BvdfCache::find(const std::string& recipe) const {
  if (!has(recipe)) return std::nullopt;
  const fs::path file = fileOf(recipe);
  std::error_code ignored;
  try {
    auto set = decode(readFile(file.string(), kMaxFileBytes), recipe);
    if (set) fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // used: not the next to go
    return set;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void BvdfCache::keep(const std::string& recipe, const BvdfSet& set) const {
  if (folder_.empty()) return;
  const std::string bytes = encode(recipe, set);
  if (bytes.size() > std::min(maxBytes_, kMaxFileBytes)) return;
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  try {
    writeFileAtomically(fileOf(recipe).string(), bytes);
  } catch (const InputError&) {
    return;  // a full or read-only disk costs the next start a bake, nothing else
  }
  prune(fileOf(recipe));
}

std::vector<BvdfCache::Entry> BvdfCache::entries() const {
  std::vector<Entry> entries;
  std::error_code error;
  for (fs::directory_iterator i(folder_, error), end; !error && i != end; i.increment(error)) {
    std::error_code gone;  // another program may prune as well
    if (i->path().extension() != kExtension) continue;
    Entry entry{i->last_write_time(gone), i->path(), i->file_size(gone)};
    if (!gone) entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used > b.used; });
  return entries;
}

void BvdfCache::prune(const fs::path& justWritten) const {
  std::vector<Entry> all = entries();
  uintmax_t total = 0;
  for (const Entry& entry : all) total += entry.bytes;
  for (; total > maxBytes_ && !all.empty(); all.pop_back()) {
    std::error_code error;
    if (all.back().file != justWritten && fs::remove(all.back().file, error)) total -= all.back().bytes;
  }
}

std::vector<std::string> BvdfCache::recipes(size_t most) const {
  constexpr uint64_t kMaxRecipeBytes = uint64_t{1} << 22;
  std::vector<std::string> recipes;
  if (folder_.empty()) return recipes;
  for (const Entry& entry : entries()) {
    if (recipes.size() == most) break;
    std::ifstream file(entry.file, std::ios::binary);
    std::string magic(kMagic.size(), ' ');
    uint64_t size = 0;
    file.read(magic.data(), static_cast<std::streamsize>(magic.size()));
    file.read(reinterpret_cast<char*>(&size), sizeof(size));
    if (!file || magic != kMagic || size > std::min<uint64_t>(entry.bytes, kMaxRecipeBytes)) continue;
    std::string recipe(size, ' ');
    if (file.read(recipe.data(), static_cast<std::streamsize>(size))) recipes.push_back(std::move(recipe));
  }
  return recipes;
}

}  // namespace loomlight
