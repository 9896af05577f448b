#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/random.h"
#include "render/film/image.h"
#include "tests/support/full_disk.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/film/exr_bytes.h"
#include "tests/unit/film/film_samples.h"

namespace loomlight {
namespace {

using test::bytesOf;
using test::ExrBytes;
using test::putBytes;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Image smallImage() {
  Image image;
  image.width = 4;
  image.height = 2;
  for (const char* name : {"R", "G", "B", "some.layer.with.depth.Z"}) {
    std::vector<float>& values = image.add(name);
    for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i) / 3 - 1;
  }
  return image;
}

ExrBytes smallFile() {
  ExrBytes exr;
  exr.channels = {{"half", ExrBytes::half, std::string("\x00\x3c\x00\xc0\x00\x38\x00\x7c", 8)},  // 1, -2, 0.5, inf
                  {"uint", ExrBytes::uint, test::int32(0) + test::int32(7) + test::int32(1 << 20) + test::int32(-1)}};
  return exr;
}

/// What reading these bytes complains of.
std::string exrComplaint(const std::string& bytes) {
  const test::ScratchFolder folder;
  putBytes(folder.file("bad.exr"), bytes);
  const std::string message = test::messageOf<InputError>([&] { readExr(folder.file("bad.exr")); });
  EXPECT_THAT(message, HasSubstr("bad.exr"));
  return message;
}

/// Red, green, blue and white of ITU-R BT.709, as programs read them that know more than one red.
TEST(Exr, OfColoursSaysWhatItsPrimariesAre) {
  const test::ScratchFolder folder;
  writeExr(folder.file("colours.exr"), smallImage());
  std::string chromaticities;
  for (const float value : {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f})
    chromaticities += test::int32(std::bit_cast<int32_t>(value));
  EXPECT_THAT(bytesOf(folder.file("colours.exr")),
              HasSubstr(ExrBytes::attribute("chromaticities", "chromaticities", chromaticities)));
  Image depth = smallImage();
  depth.channels.erase(depth.channels.begin());
  writeExr(folder.file("depth.exr"), depth);
  EXPECT_THAT(bytesOf(folder.file("depth.exr")), testing::Not(HasSubstr("chromaticities"))) << "no colours";
}

TEST(Exr, RoundTripKeepsEveryBit) {
  const test::ScratchFolder folder;
  Image image = smallImage();
  image.add("odd") = {std::numeric_limits<float>::infinity(),
                      -0.0f,
                      std::numeric_limits<float>::denorm_min(),
                      std::numeric_limits<float>::max(),
                      std::numeric_limits<float>::quiet_NaN(),
                      1e-30f,
                      16777216,
                      -1};
  writeExr(folder.file("a.exr"), image);
  test::expectSameImage(image, readExr(folder.file("a.exr")));
}

TEST(Exr, SaysHowLargeItIsOnPaper) {
  const test::ScratchFolder folder;
  const std::string name("xDensity\0float\0", 15);
  writeExr(folder.file("a.exr"), smallImage(), 300);
  EXPECT_NE(
      readFile(folder.file("a.exr"), 1 << 20).find(name + test::int32(4) + test::int32(std::bit_cast<int>(300.0f))),
      std::string::npos);
  writeExr(folder.file("b.exr"), smallImage());
  EXPECT_EQ(readFile(folder.file("b.exr"), 1 << 20).find(name), std::string::npos);
}

TEST(Exr, ItsExtentIsKnownWithoutItsPixels) {
  const test::ScratchFolder folder;
  Image image;
  image.width = 7;
  image.height = 5;
  for (const char* name : {"R", "G", "B", "A"}) image.add(name);
  writeExr(folder.file("a.exr"), image);
  std::string bytes = readFile(folder.file("a.exr"), 1 << 20);
  std::fill(bytes.end() - 8, bytes.end(), 'x');  // pixels that cannot be decoded
  writeFileAtomically(folder.file("a.exr"), bytes);
  const PictureExtent extent = readExrExtent(folder.file("a.exr"));
  EXPECT_EQ(extent.width, 7);
  EXPECT_EQ(extent.height, 5);
  EXPECT_EQ(extent.channels, 4);
  writeFileAtomically(folder.file("a.exr"), "no picture");
  EXPECT_THROW(readExrExtent(folder.file("a.exr")), InputError);
}

TEST(Exr, RoundTripKeepsTexts) {
  const test::ScratchFolder folder;
  Image image = smallImage();
  std::string json = "{\"weave\": [";
  while (json.size() < 400000) json += "\n  \"Köper \\u00e9 0110\",";
  image.metadata = {{"fabric", json},
                    {"aNameOfMoreThanThirtyOneCharactersThatOldReadersRefuse", "x"},
                    {"empty", ""},
                    {"zeros", std::string("a\0b", 3)}};
  writeExr(folder.file("a.exr"), image);
  const auto texts = readExr(folder.file("a.exr")).metadata;
  for (const auto& [key, value] : image.metadata) {
    ASSERT_TRUE(texts.contains(key)) << key;
    EXPECT_EQ(texts.at(key), value) << key;
  }
}

TEST(Exr, TextsMayNotTakeTheFormatsOwnNames) {
  const test::ScratchFolder folder;
  Image image = smallImage();
  image.metadata["compression"] = "none, please";
  EXPECT_THROW(writeExr(folder.file("a.exr"), image), InputError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Exr, ReadsHalfAndUintFromAnyWindow) {
  const test::ScratchFolder folder;
  for (const bool tiled : {false, true}) {
    ExrBytes exr = smallFile();
    exr.tiled = tiled;
    exr.minX = tiled ? 0 : -100;
    exr.minY = tiled ? 0 : 70000;
    putBytes(folder.file("a.exr"), exr.all());
    const Image image = readExr(folder.file("a.exr"));
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.height, 2);
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_THAT(image.find("half")->values, ElementsAre(1, -2, 0.5f, infinity, 1, -2, 0.5f, infinity));
    EXPECT_THAT(image.find("uint")->values, ElementsAre(0, 7, 0x1p20f, 0x1p32f, 0, 7, 0x1p20f, 0x1p32f));
  }
}

TEST(Exr, RefusesSubsampledChannels) {
  ExrBytes exr = smallFile();
  exr.channels[0].sampling = 2;
  EXPECT_THAT(exrComplaint(exr.all()), AllOf(HasSubstr("half"), HasSubstr("subsampled")));
  exr.channels[0].name = "\xFF\x07";
  EXPECT_THAT(exrComplaint(exr.all()), HasSubstr("channel ?? is"));
}

TEST(Exr, RefusesDeepFiles) {
  ExrBytes exr = smallFile();
  exr.versionFlags = 0x800;
  EXPECT_THAT(exrComplaint(exr.all()), HasSubstr("deep"));
}

TEST(Exr, RefusesHugeClaimsWithoutBelievingThem) {
  ExrBytes wide = smallFile();
  wide.width = 2000000000;
  EXPECT_THAT(exrComplaint(wide.header()), HasSubstr("2000000000 x 2 pixels is too large"));
  ExrBytes high = smallFile();
  high.height = 16385;
  EXPECT_THAT(exrComplaint(high.header()), HasSubstr("4 x 16385 pixels is too large"));
  ExrBytes negative = smallFile();
  negative.width = -5;
  EXPECT_THAT(exrComplaint(negative.header()), HasSubstr("damaged"));
  ExrBytes full = smallFile();
  full.width = full.height = 16384;
  full.channels.resize(4);
  for (size_t i = 0; i < 4; ++i) full.channels[i].name = std::string(20, static_cast<char>('a' + i));
  EXPECT_THAT(exrComplaint(full.header()), HasSubstr("2 GB"));
  ExrBytes attribute = smallFile();
  attribute.extraAttributes = ExrBytes::attribute("comments", "string", "short", 2000000000);
  EXPECT_THAT(exrComplaint(attribute.header()), HasSubstr("damaged"));
}

// OpenEXR goes on reading where it takes an attribute to end, and finds there what a check by these sizes has passed
// over.
TEST(Exr, RefusesAttributesThatEndElsewhereThanTheySay) {
  const std::string hidden = ExrBytes::attribute("hidden", "nonsense", "", 0x6F630000);
  const auto refused = [](const std::string& attribute) {
    ExrBytes exr = smallFile();
    exr.extraAttributes = attribute;
    return exrComplaint(exr.all()).find("damaged EXR header") != std::string::npos;
  };
  EXPECT_TRUE(refused(ExrBytes::attribute("place", "v2f", std::string(8, '\0') + hidden)));
  EXPECT_TRUE(refused(ExrBytes::attribute("turn", "m44f", "")));
  EXPECT_TRUE(refused(ExrBytes::attribute("more", "chlist", std::string(1, '\0') + hidden)));
  EXPECT_TRUE(refused(ExrBytes::attribute("words", "stringvector", test::int32(0x6F630000) + "few")));
  EXPECT_TRUE(refused(ExrBytes::attribute("small", "preview", test::int32(9000) + test::int32(9000))));
}

TEST(Exr, ReadsAttributesOfOtherPrograms) {
  ExrBytes exr = smallFile();
  exr.extraAttributes = ExrBytes::attribute("words", "stringvector", test::int32(3) + "one" + test::int32(0)) +
                        ExrBytes::attribute("small", "preview", test::int32(1) + test::int32(2) + "12345678") +
                        ExrBytes::attribute("time", "timecode", std::string(8, '\1')) +
                        ExrBytes::attribute("own", "something of its own", "12345");
  const test::ScratchFolder folder;
  putBytes(folder.file("a.exr"), exr.all());
  EXPECT_EQ(readExr(folder.file("a.exr")).width, 4);
}

TEST(Exr, RefusesWhatIsNoExr) {
  EXPECT_THAT(exrComplaint(""), HasSubstr("damaged EXR header"));
  EXPECT_THAT(exrComplaint("These are the threads of a story, and no picture at all."), HasSubstr("not an EXR file"));
  Random random(1);
  std::string garbage(5000, ' ');
  for (char& c : garbage) c = static_cast<char>(random.next());
  EXPECT_THAT(exrComplaint(garbage), HasSubstr("not an EXR file"));
}

TEST(Exr, RefusesWhatIsNoFile) {
  const test::ScratchFolder folder;
  EXPECT_THAT(test::messageOf<InputError>([&] { readExr(folder.file("none.exr")); }), HasSubstr("no such file"));
  EXPECT_THAT(test::messageOf<InputError>([&] { readExr(folder.file("")); }), HasSubstr("not a regular file"));
  ASSERT_EQ(mkfifo(folder.file("pipe.exr").c_str(), 0600), 0);
  EXPECT_THAT(test::messageOf<InputError>([&] { readExr(folder.file("pipe.exr")); }), HasSubstr("not a regular file"));
}

TEST(Exr, EveryTruncationIsRefused) {
  const test::ScratchFolder folder;
  writeExr(folder.file("a.exr"), smallImage());
  const std::string bytes = bytesOf(folder.file("a.exr"));
  for (size_t length = 0; length < bytes.size(); ++length) {
    putBytes(folder.file("cut.exr"), bytes.substr(0, length));
    EXPECT_THROW(readExr(folder.file("cut.exr")), InputError) << length << " of " << bytes.size() << " bytes";
  }
}

TEST(Exr, DamagedBytesNeverDoMoreThanThrow) {
  const test::ScratchFolder folder;
  writeExr(folder.file("a.exr"), smallImage());
  const std::string sound = bytesOf(folder.file("a.exr"));
  Random random(2);
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string bytes = sound;
    for (uint32_t k = 0; k <= random.below(3); ++k)
      bytes[random.below(static_cast<uint32_t>(bytes.size()))] = static_cast<char>(random.next());
    putBytes(folder.file("b.exr"), bytes);
    try {
      const Image image = readExr(folder.file("b.exr"));
      for (const Image::Channel& channel : image.channels)
        EXPECT_EQ(channel.values.size(), static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Exr, FailedWritesNameTheFileAndLeaveTheOldOne) {
  const test::ScratchFolder folder;
  const std::string nowhere = folder.file("no/such/folder/a.exr");
  EXPECT_THAT(test::messageOf<InputError>([&] { writeExr(nowhere, smallImage()); }), HasSubstr(nowhere));

  const std::string file = folder.file("a.exr");
  writeExr(file, smallImage());
  const std::string before = bytesOf(file);
  Image large = smallImage();
  large.metadata["noise"] = std::string(300000, 'x');
  {
    const test::FullDisk full(100000);
    EXPECT_THAT(test::messageOf<InputError>([&] { writeExr(file, large); }), HasSubstr(file));
  }
  EXPECT_EQ(bytesOf(file), before);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, APartLiesWhereItLayInTheWhole) {
  const test::ScratchFolder folder;
  Image image;
  image.width = 3;
  image.height = 2;
  image.left = 4;
  image.top = 5;
  image.wholeWidth = 10;
  image.wholeHeight = 8;
  image.metadata["loomlight.note"] = "a part";
  image.add("R") = {1, 2, 3, 4, 5, 6};
  writeExr(folder.file("a.exr"), image);
  const Image read = readExr(folder.file("a.exr"));
  EXPECT_EQ(read.left, 4);
  EXPECT_EQ(read.top, 5);
  EXPECT_EQ(read.wholeWidth, 10);
  EXPECT_EQ(read.wholeHeight, 8);
  EXPECT_EQ(read.find("R")->values, image.channels[0].values);
  EXPECT_EQ(readExrTexts(folder.file("a.exr")).at("loomlight.note"), "a part");
}

TEST(Exr, ImpossibleSizesAreNotWritten) {
  const test::ScratchFolder folder;
  Image image;
  EXPECT_THROW(writeExr(folder.file("a.exr"), image), InputError);
  image.width = 16385;
  image.height = 1;
  EXPECT_THROW(writeExr(folder.file("a.exr"), image), InputError);
}

}  // namespace
}  // namespace loomlight
