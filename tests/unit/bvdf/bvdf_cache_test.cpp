#include "render/bvdf/bvdf_cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>

#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using test::bytesOf;
using test::putBytes;
using test::ScratchFolder;

BvdfSet someTables(float seed) {
  const BvdfResolution resolution{2, 2, 4, 4};
  BvdfSet set;
  set.rays = 1234;
  for (int t = 0; t < 2; ++t) {
    std::vector<float> ratios(resolution.bins());
    for (size_t i = 0; i < ratios.size(); ++i) ratios[i] = seed + static_cast<float>(i) / 7 + static_cast<float>(t);
    set.tables.emplace_back(resolution, HotSpot{1 + seed, 0.5f}, std::move(ratios));
  }
  return set;
}

bool sameTables(const BvdfSet& a, const BvdfSet& b) {
  if (a.rays != b.rays || a.tables.size() != b.tables.size()) return false;
  for (size_t i = 0; i < a.tables.size(); ++i)
    if (!(a.tables[i].resolution() == b.tables[i].resolution()) ||
        a.tables[i].hotSpot().depth != b.tables[i].hotSpot().depth ||
        a.tables[i].hotSpot().reach != b.tables[i].hotSpot().reach ||
        !std::equal(a.tables[i].ratios().begin(), a.tables[i].ratios().end(), b.tables[i].ratios().begin(),
                    b.tables[i].ratios().end()))
      return false;
  return true;
}

TEST(BvdfCache, GivesBackTheIdenticalTables) {
  const ScratchFolder folder;
  const BvdfCache cache(folder.file("a/b"));
  EXPECT_FALSE(cache.find("plain weave"));
  cache.keep("plain weave", someTables(1));
  cache.keep("twill", someTables(2));
  ASSERT_TRUE(cache.find("plain weave"));
  EXPECT_TRUE(sameTables(*cache.find("plain weave"), someTables(1)));
  EXPECT_TRUE(sameTables(*cache.find("twill"), someTables(2)));
  EXPECT_FALSE(cache.find("satin"));
}

TEST(BvdfCache, IgnoresDamagedFilesAtEveryByte) {
  const ScratchFolder folder;
  const BvdfCache cache(folder.file(""));
  cache.keep("plain", someTables(1));
  const std::string file = cache.fileOf("plain").string(), good = bytesOf(file);
  for (size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x20);
    putBytes(file, bad);
    ASSERT_FALSE(cache.find("plain")) << "byte " << i;
  }
  for (size_t length = 0; length < good.size(); length += 5) {
    putBytes(file, good.substr(0, length));
    ASSERT_FALSE(cache.find("plain")) << "cut to " << length;
  }
  putBytes(file, good + "more");
  EXPECT_FALSE(cache.find("plain"));
  cache.keep("plain", someTables(1));
  EXPECT_TRUE(cache.find("plain"));
}

TEST(BvdfCache, IgnoresForeignFiles) {
  const ScratchFolder folder;
  const BvdfCache cache(folder.file(""));
  cache.keep("plain", someTables(1));
  // Another recipe's tables under this one's name, as after a collision of names.
  putBytes(cache.fileOf("twill").string(), bytesOf(cache.fileOf("plain").string()));
  EXPECT_FALSE(cache.find("twill"));
  putBytes(cache.fileOf("twill").string(), "a letter to a friend, much longer than any header would be");
  EXPECT_FALSE(cache.find("twill"));
  std::filesystem::remove(cache.fileOf("twill"));
  std::filesystem::create_directory(cache.fileOf("twill"));
  EXPECT_FALSE(cache.find("twill"));
}

TEST(BvdfCache, KeepsWithinItsSizeAndDropsTheLeastRecentlyUsed) {
  const ScratchFolder folder;
  BvdfCache(folder.file("")).keep("0", someTables(0));
  const size_t each = bytesOf(BvdfCache(folder.file("")).fileOf("0").string()).size();
  const BvdfCache cache(folder.file(""), 3 * each);
  const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  for (const char* name : {"0", "1", "2"}) {
    cache.keep(name, someTables(0));
    std::filesystem::last_write_time(cache.fileOf(name), old);
  }
  EXPECT_TRUE(cache.find("0"));  // used again
  cache.keep("3", someTables(0));
  EXPECT_EQ(folder.entries(), 3u);
  EXPECT_TRUE(cache.find("0"));
  EXPECT_TRUE(cache.find("3"));
  const BvdfCache tiny(folder.file("tiny"), each - 1);
  tiny.keep("4", someTables(0));
  EXPECT_FALSE(tiny.find("4"));
}

TEST(BvdfCache, LivesWithoutADisk) {
  const BvdfCache none{std::filesystem::path()}, unwritable("/proc/no-such-folder");
  for (const BvdfCache* cache : {&none, &unwritable}) {
    EXPECT_NO_THROW(cache->keep("plain", someTables(1)));
    EXPECT_FALSE(cache->find("plain"));
  }
}

/// Sets a variable of the environment, and sets it back.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value, 1);
  }
  ~Variable() {
    if (before_) {
      ::setenv(name_, before_->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(BvdfCache, IsInTheUsersCacheFolder) {
  const Variable home("HOME", "/home/weaver");
  {
    const Variable cache("XDG_CACHE_HOME", "/somewhere/cache");
    EXPECT_EQ(BvdfCache::userFolder(), "/somewhere/cache/loomlight/bvdf");
  }
  const Variable cache("XDG_CACHE_HOME", "relative/is/ignored");
  EXPECT_EQ(BvdfCache::userFolder(), "/home/weaver/.cache/loomlight/bvdf");
}

}  // namespace
}  // namespace loomlight
