#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/film/image.h"
#include "tests/support/mutated.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

constexpr int kFiles = 400;

/// Reads a file or refuses it as bad input. How many of so many mutants are read.
template <class Read>
int readable(const std::string& name, const std::string& bytes, uint64_t seed, const Read& read) {
  const test::ScratchFolder folder;
  Random random(seed);
  int good = 0;
  for (int i = 0; i < kFiles; ++i) {
    test::putBytes(folder.file(name), test::mutated(bytes, random));
    try {
      read(folder.file(name));
      ++good;
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(name), std::string::npos) << said;
      for (const char c : said) EXPECT_TRUE(c >= 0x20 && c < 0x7F) << said;
    }
  }
  return good;
}

/// That all are read, or none, would say that the files were not what they should be.
void expectSome(int good) {
  EXPECT_GT(good, kFiles / 100);
  EXPECT_LT(good, kFiles - kFiles / 100);
}

TEST(MutatedFiles, Png) {
  const test::ScratchFolder folder;
  Random random(1);
  Pixels8 pixels{13, 9, 4, {}};
  for (int i = 0; i < 13 * 9 * 4; ++i) pixels.bytes.push_back(static_cast<uint8_t>(random.below(256)));
  writePng(folder.file("good.png"), pixels, {{"a text", std::string(3000, 'x')}});
  const std::string bytes = test::bytesOf(folder.file("good.png"));
  expectSome(readable("bad.png", bytes, 2, [](const std::string& file) {
    std::map<std::string, std::string> texts;
    const Pixels8 read = readPng(file, &texts);
    EXPECT_EQ(read.bytes.size(), static_cast<size_t>(read.width) * read.height * read.channels);
  }));
}

TEST(MutatedFiles, Exr) {
  const test::ScratchFolder folder;
  Image image;
  image.width = 11;
  image.height = 7;
  image.metadata["a text"] = "of some length";
  Random random(3);
  for (const char* name : {"R", "G", "B", "depth.Z"})
    for (float& value : image.add(name)) value = random.uniform();
  writeExr(folder.file("good.exr"), image);
  const std::string bytes = test::bytesOf(folder.file("good.exr"));
  expectSome(readable("bad.exr", bytes, 4, [](const std::string& file) {
    const Image read = readExr(file);
    for (const Image::Channel& channel : read.channels)
      EXPECT_EQ(channel.values.size(), static_cast<size_t>(read.width) * read.height) << channel.name;
  }));
}

}  // namespace
}  // namespace loomlight
