#include "core/base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "tests/support/full_disk.h"

namespace loomlight {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test.
class File : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("loomlight_" + std::to_string(::getpid()) + "_" +
                                              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  size_t filesInFolder() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(File, ContentComesBackByteForByte) {
  std::string content = "first\r\nsecond";
  content += '\0';
  content += "\xff";
  writeFileAtomically(at("a"), content);
  EXPECT_EQ(readFile(at("a"), 1000), content);
  writeFileAtomically(at("a"), "");
  EXPECT_EQ(readFile(at("a"), 1000), "");
}

TEST_F(File, LeavesNothingBeside) {
  for (int i = 0; i < 5; ++i) writeFileAtomically(at("a"), "x");
  EXPECT_THROW(writeFileAtomically(at("missing/b"), "x"), InputError);
  fs::create_directories(at("folder/full"));
  EXPECT_THROW(writeFileAtomically(at("folder"), "x"), InputError) << "a folder cannot be replaced";
  EXPECT_EQ(filesInFolder(), 2u);
}

TEST_F(File, NamesMayBeAsLongAsNamesCanBe) {
  const std::string longest(255, 'n');
  writeFileAtomically(at(longest), "x");
  EXPECT_EQ(readFile(at(longest), 10), "x");
  EXPECT_EQ(filesInFolder(), 1u);
  EXPECT_THROW(writeFileAtomically(at(longest + "n"), "x"), InputError);
}

TEST_F(File, ReplacedFileKeepsItsPermissions) {
  writeFileAtomically(at("a"), "x");
  ASSERT_EQ(::chmod(at("a").c_str(), 0640), 0);
  writeFileAtomically(at("a"), "y");
  struct stat status{};
  ASSERT_EQ(::stat(at("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(File, ReplacesWhatALinkPointsTo) {
  writeFileAtomically(at("real"), "x");
  fs::create_symlink(at("real"), at("link"));
  writeFileAtomically(at("link"), "y");
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(readFile(at("real"), 10), "y");
}

TEST_F(File, ReaderSeesOldOrNewNeverPart) {
  const std::string a(200'000, 'a'), b(100'000, 'b');
  writeFileAtomically(at("f"), a);
  std::jthread writer([&](std::stop_token stop) {
    for (int i = 0; i < 20 && !stop.stop_requested(); ++i) writeFileAtomically(at("f"), i % 2 ? a : b);
  });
  for (int i = 0; i < 200; ++i) {
    const std::string seen = readFile(at("f"), 1'000'000);
    ASSERT_TRUE(seen == a || seen == b);
  }
}

TEST_F(File, WhatIsNoRegularFileIsNeverReplaced) {
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  fs::create_symlink(at("pipe"), at("link"));
  for (const std::string& name : {at("pipe"), at("link")}) {
    EXPECT_THROW(expectWritable(name), InputError);
    EXPECT_THROW(writeFileAtomically(name, "x"), InputError);
  }
  EXPECT_TRUE(fs::is_fifo(at("pipe")));
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(filesInFolder(), 2u);
}

TEST_F(File, ALinkToItselfIsNoPlaceForAFile) {
  fs::create_symlink(at("loop"), at("loop"));
  EXPECT_THROW(readFile(at("loop"), 10), InputError);
  EXPECT_THROW(writeFileAtomically(at("loop"), "x"), InputError);
  EXPECT_TRUE(fs::is_symlink(at("loop")));
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(File, AFailedWriteLeavesTheOldFile) {
  writeFileAtomically(at("a"), "old");
  {
    const test::FullDisk full(1000);
    EXPECT_THROW(writeFileAtomically(at("a"), std::string(2000, 'x')), InputError);
  }
  EXPECT_EQ(readFile(at("a"), 10), "old");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(File, AStoppedWriteLeavesTheOldFile) {
  writeFileAtomically(at("a"), "old");
  std::stop_source source;
  EXPECT_TRUE(writeFileAtomically(at("a"), "new", source.get_token()));
  source.request_stop();
  EXPECT_FALSE(writeFileAtomically(at("a"), std::string(2000, 'x'), source.get_token()));
  EXPECT_EQ(readFile(at("a"), 10), "new");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(File, WhereNothingCanBeWrittenIsKnownBeforehand) {
  EXPECT_NO_THROW(expectWritable(at("new")));
  EXPECT_EQ(filesInFolder(), 0u);
  EXPECT_NO_THROW(expectWritable("new, in the folder where we are"));
  fs::create_directories(at("folder"));
  EXPECT_THROW(expectWritable(at("folder")), InputError);
  EXPECT_THROW(expectWritable(at("missing/new")), InputError);
}

TEST_F(File, WhatCannotBeReadIsNamed) {
  const auto complaint = [](const std::string& file, size_t most) {
    try {
      readFile(file, most);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(at("none"), 10), at("none") + ": cannot be opened: No such file or directory");
  EXPECT_THAT(complaint(folder_.string(), 10), testing::HasSubstr("expected a regular file"));
  EXPECT_THAT(complaint("/dev/zero", 10), testing::HasSubstr("expected a regular file"));
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  EXPECT_THAT(complaint(at("pipe"), 10), testing::HasSubstr("expected a regular file")) << "and it must not wait";
  writeFileAtomically(at("large"), std::string(2'000'001, 'x'));
  EXPECT_EQ(complaint(at("large"), 2'000'000), at("large") + ": expected a file of at most 2 MB");
  EXPECT_EQ(complaint(at("large"), 2'000'001), "");
}

TEST_F(File, HugeFileIsRefusedUnread) {
  writeFileAtomically(at("sparse"), "x");
  fs::resize_file(at("sparse"), 1'000'000'000'000);
  EXPECT_THROW(readFile(at("sparse"), 1'000'000), InputError);
}

}  // namespace
}  // namespace loomlight
