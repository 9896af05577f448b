#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "app/editor/model/left_work.h"
#include "app/editor/model/settings.h"
#include "app/editor/presets/preset_tags.h"
#include "tests/support/mutated.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

constexpr int kFiles = 300;

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What the editor keeps for itself may be damaged like any other file.
class MutatedFiles : public testing::Test {
 protected:
  MutatedFiles() : folder_(fs::path(testing::TempDir()) / ("loomlight-mutated-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MutatedFiles() override { fs::remove_all(folder_); }

  /// Replaces a good file by damaged ones. That all are read, or none, would say that they are not what they should be.
  void expectSomeRead(const fs::path& file, uint64_t seed, const std::function<bool()>& read) {
    const std::string good = bytesOf(file);
    ASSERT_FALSE(good.empty());
    Random random(seed);
    int readable = 0;
    for (int i = 0; i < kFiles; ++i) {
      std::ofstream(file, std::ios::binary) << test::mutated(good, random);
      readable += read();
    }
    EXPECT_GT(readable, kFiles / 100);
    EXPECT_LT(readable, kFiles - kFiles / 100);
  }

  fs::path folder_;
};

TEST_F(MutatedFiles, Settings) {
  const fs::path file = folder_ / "editor.json";
  Settings settings;
  settings.windowWidth = 1777;
  settings.recent = {{"/a.json", false}};
  writeSettings(file, settings);
  expectSomeRead(file, 1, [&] {
    const Settings read = readSettings(file);
    EXPECT_GE(read.windowWidth, 960);
    EXPECT_LE(read.windowWidth, 16384);
    EXPECT_GE(read.draft.loom.shafts, 1);
    EXPECT_LE(read.dock.draftWidth, 4000.0f);
    return read.windowWidth == 1777;
  });
}

TEST_F(MutatedFiles, PresetTags) {
  const fs::path file = folder_ / "tags.json";
  PresetTags(file).set("Denim", "blue, \xC3\xA9t\xC3\xA9");
  expectSomeRead(file, 2, [&] {
    const PresetTags tags(file);
    EXPECT_TRUE(tags.problem().empty() || tags.of("Denim").empty()) << "read, and said to be unreadable";
    return tags.problem().empty();
  });
}

TEST_F(MutatedFiles, LeftWork) {
  const fs::path file = folder_ / "autosave.json";
  std::ofstream(file) << R"({"loomlight_version": 1, "name": "Blue twill", "weave": ["#.", ".#"]})";
  expectSomeRead(file, 3, [&] {
    const std::string about = aboutLeftWork(file);
    EXPECT_NE(about.find("was last edited"), std::string::npos) << about;
    return about.find("Blue twill") != std::string::npos;
  });
}

}  // namespace
}  // namespace loomlight
