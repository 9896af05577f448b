#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "render/film/image.h"
#include "render/film/srgb_profile.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using test::bytesOf;
using test::putBytes;
using testing::HasSubstr;

Pixels8 noise(int width, int height, int channels) {
  Pixels8 pixels{width, height, channels, {}};
  Random random(4);
  for (int i = 0; i < width * height * channels; ++i) pixels.bytes.push_back(static_cast<uint8_t>(random.next()));
  return pixels;
}

uint32_t bigEndian(const std::string& bytes, size_t at) {
  uint32_t n = 0;
  for (size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<uint8_t>(bytes[at + i]);
  return n;
}

/// CRC-32 bit by bit, without the table of the writer.
uint32_t slowCrc(const std::string& bytes) {
  uint32_t c = ~0u;
  for (const char byte : bytes) {
    c ^= static_cast<uint8_t>(byte);
    for (int k = 0; k < 8; ++k) c = (c >> 1) ^ (0xEDB88320u & (0 - (c & 1)));
  }
  return ~c;
}

struct Chunk {
  std::string type, data;
};

std::vector<Chunk> chunksOf(const std::string& png) {
  std::vector<Chunk> chunks;
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  for (size_t at = 8; at + 12 <= png.size();) {
    const size_t length = bigEndian(png, at);
    chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
    EXPECT_EQ(bigEndian(png, at + 8 + length), slowCrc(png.substr(at + 4, 4 + length))) << chunks.back().type;
    at += 12 + length;
  }
  return chunks;
}

std::string pngComplaint(const std::string& bytes) {
  const test::ScratchFolder folder;
  putBytes(folder.file("bad.png"), bytes);
  const std::string message = test::messageOf<InputError>([&] { readPng(folder.file("bad.png")); });
  EXPECT_THAT(message, HasSubstr("bad.png"));
  return message;
}

TEST(Png, SaysHowLargeItIsOnPaper) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(3, 2, 3), {}, 300);
  writePng(folder.file("b.png"), noise(3, 2, 3));
  const auto sizeOf = [&](const char* name) {
    for (const Chunk& chunk : chunksOf(bytesOf(folder.file(name))))
      if (chunk.type == "pHYs") return chunk.data;
    return std::string();
  };
  const std::string size = sizeOf("a.png");
  ASSERT_EQ(size.size(), 9u);
  EXPECT_EQ(bigEndian(size, 0), 11811u) << "300 / 0.0254 pixels per metre";
  EXPECT_EQ(bigEndian(size, 4), 11811u);
  EXPECT_EQ(size[8], 1) << "the unit is the metre";
  EXPECT_EQ(sizeOf("b.png"), "");
}

TEST(Png, TextsComeBack) {
  const test::ScratchFolder folder;
  const std::map<std::string, std::string> texts{{"Title", "Caf\u00E9"},
                                                 {"loomlight.fabric", std::string(100000, 'x')}};
  writePng(folder.file("a.png"), noise(3, 2, 4), texts, 72);
  std::map<std::string, std::string> read;
  EXPECT_EQ(readPng(folder.file("a.png"), &read).bytes, noise(3, 2, 4).bytes);
  EXPECT_EQ(read, texts);
  const std::string whole = bytesOf(folder.file("a.png"));
  for (const size_t length : {size_t{0}, size_t{7}, size_t{20}, size_t{60}, whole.size() - 1}) {
    putBytes(folder.file("cut.png"), whole.substr(0, length));
    EXPECT_THROW(readPng(folder.file("cut.png"), &read), InputError) << length;
  }
}

TEST(Png, RoundTripKeepsEveryByte) {
  const test::ScratchFolder folder;
  for (const int channels : {3, 4}) {
    const Pixels8 pixels = noise(37, 11, channels);
    writePng(folder.file("a.png"), pixels);
    const Pixels8 read = readPng(folder.file("a.png"));
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 11);
    EXPECT_EQ(read.channels, channels);
    EXPECT_EQ(read.bytes, pixels.bytes);
  }
}

TEST(Png, ItsExtentIsKnownWithoutItsPixels) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(37, 11, 4));
  putBytes(folder.file("cut.png"), bytesOf(folder.file("a.png")).substr(0, 40));
  for (const char* name : {"a.png", "cut.png"}) {
    const PictureExtent extent = readPngExtent(folder.file(name));
    EXPECT_EQ(extent.width, 37);
    EXPECT_EQ(extent.height, 11);
    EXPECT_EQ(extent.channels, 4);
  }
  putBytes(folder.file("cut.png"), "no picture");
  EXPECT_THROW(readPngExtent(folder.file("cut.png")), InputError);
  EXPECT_THROW(readPngExtent(folder.file("none.png")), InputError);
}

TEST(Png, TextsAndColourSpaceStandBeforeThePixels) {
  const test::ScratchFolder folder;
  const std::string json(400000, '{');
  writePng(folder.file("a.png"), noise(8, 8, 3), {{"fabric", json}, {"Software", "Loomlight äöü"}});
  const std::vector<Chunk> chunks = chunksOf(bytesOf(folder.file("a.png")));
  ASSERT_GE(chunks.size(), 6u);
  EXPECT_EQ(chunks[0].type, "IHDR");
  EXPECT_EQ(chunks[1].type, "iCCP");
  EXPECT_EQ(chunks[2].type, "iTXt");
  EXPECT_EQ(chunks[2].data, "Software" + std::string(5, '\0') + "Loomlight äöü");
  EXPECT_EQ(chunks[3].type, "iTXt");
  EXPECT_EQ(chunks[3].data, "fabric" + std::string(5, '\0') + json);
  EXPECT_EQ(chunks[4].type, "IDAT");
  EXPECT_EQ(chunks.back().type, "IEND");
  EXPECT_EQ(readPng(folder.file("a.png")).bytes, noise(8, 8, 3).bytes);
}

/// One profile, and nothing beside it that would say the same: a reader need not choose.
TEST(Png, ColoursCarryTheirProfile) {
  const test::ScratchFolder folder;
  for (const int channels : {3, 4}) {
    writePng(folder.file("a.png"), noise(3, 2, channels));
    std::vector<std::string> profiles;
    for (const Chunk& chunk : chunksOf(bytesOf(folder.file("a.png")))) {
      EXPECT_NE(chunk.type, "sRGB");
      EXPECT_NE(chunk.type, "gAMA");
      if (chunk.type == "iCCP") profiles.push_back(chunk.data);
    }
    ASSERT_EQ(profiles.size(), 1u);
    const std::string name("sRGB\0\0", 6);  // the second 0: deflated
    ASSERT_EQ(profiles[0].substr(0, name.size()), name);
    std::string profile(100'000, '\0');
    uLongf size = profile.size();
    ASSERT_EQ(
        uncompress(reinterpret_cast<Bytef*>(profile.data()), &size,
                   reinterpret_cast<const Bytef*>(profiles[0].data() + name.size()), profiles[0].size() - name.size()),
        Z_OK);
    EXPECT_EQ(profile.substr(0, size), sRgbProfile());
  }
}

/// A picture is the same whenever it is made, so its profile has no date of now.
TEST(Png, TheProfileIsOfTheDayOfTheStandard) {
  const std::string profile = sRgbProfile();
  EXPECT_EQ(bigEndian(profile, 24) >> 16, 1999u);
  EXPECT_EQ(bigEndian(profile, 0), profile.size());
  EXPECT_EQ(profile.substr(36, 4), "acsp");
}

TEST(Png, NamesOfTextsKeepToTheFormat) {
  const test::ScratchFolder folder;
  EXPECT_THROW(writePng(folder.file("a.png"), noise(2, 2, 3), {{"", "x"}}), InputError);
  EXPECT_THROW(writePng(folder.file("a.png"), noise(2, 2, 3), {{std::string(80, 'k'), "x"}}), InputError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Png, RefusesWhatIsNoPng) {
  EXPECT_THAT(pngComplaint(""), HasSubstr("not a PNG file"));
  EXPECT_THAT(pngComplaint("P3 2 2 255 0 0 0"), HasSubstr("not a PNG file"));
  EXPECT_THAT(pngComplaint(std::string(100, '\xff')), HasSubstr("not a PNG file"));
  const test::ScratchFolder folder;
  EXPECT_THROW(readPng(folder.file("none.png")), InputError);
  EXPECT_THROW(readPng(folder.file("")), InputError);
}

TEST(Png, RefusesHugeClaims) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(2, 2, 3));
  std::string bytes = bytesOf(folder.file("a.png"));
  bytes[17] = '\x01';  // 65538 pixels wide
  EXPECT_THAT(pngComplaint(bytes), HasSubstr("16384"));
}

/// The file with other dimensions, and the checksum that goes with them.
std::string claiming(std::string png, uint32_t width, uint32_t height) {
  const auto put = [&png](size_t at, uint32_t n) {
    for (size_t i = 0; i < 4; ++i) png[at + i] = static_cast<char>(n >> (24 - 8 * i));
  };
  put(16, width);
  put(20, height);
  put(29, slowCrc(png.substr(12, 17)));
  return png;
}

TEST(Png, HugeClaimsAreRefusedByTheHeader) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(2, 2, 3));
  const std::string sound = bytesOf(folder.file("a.png"));
  ASSERT_EQ(claiming(sound, 2, 2), sound);
  EXPECT_THAT(pngComplaint(claiming(sound, 16385, 2)), HasSubstr("IHDR"));
  EXPECT_THAT(pngComplaint(claiming(sound, 2, 1u << 30)), HasSubstr("IHDR"));
  EXPECT_THAT(pngComplaint(claiming(sound, 16384, 16384)), HasSubstr("too short for 16384 x 16384 pixels"))
      << "its pixels would take 800 MB, and are not there";
  const size_t behindHeader = 33;
  EXPECT_THAT(pngComplaint(std::string(sound).insert(behindHeader, std::string("\x44\x49\x48\0zTXt", 8))),
              HasSubstr("it breaks off"))
      << "a chunk of a gigabyte";
  putBytes(folder.file("b.png"), claiming(sound, 16385, 2));
  EXPECT_THROW(readPngExtent(folder.file("b.png")), InputError);
}

TEST(Png, SaysWhatIsWrongWithADamagedFile) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(20, 20, 3));
  const std::string sound = bytesOf(folder.file("a.png"));
  EXPECT_THAT(pngComplaint(sound.substr(0, sound.size() / 2)), HasSubstr("damaged PNG file: it breaks off"));
  std::string turned = sound;
  turned[turned.size() / 2] = static_cast<char>(turned[turned.size() / 2] ^ 1);
  EXPECT_THAT(pngComplaint(turned), HasSubstr("damaged PNG file: IDAT"));
}

// Heights and normals: 256 steps of either show as terraces.
TEST(Png, NumbersKeepTheir16Bits) {
  const test::ScratchFolder folder;
  for (const int channels : {1, 3}) {
    Pixels16 numbers{31, 17, channels, {}};
    Random random(7);
    for (int i = 0; i < 31 * 17 * channels; ++i) numbers.values.push_back(static_cast<uint16_t>(random.next()));
    writePng(folder.file("a.png"), numbers, 300);
    for (const Chunk& chunk : chunksOf(bytesOf(folder.file("a.png")))) EXPECT_NE(chunk.type, "iCCP") << "no colours";
    // As a reader that is not ours has them: without a colour space, 16 bits are linear.
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&image, folder.file("a.png").c_str()));
    image.format = channels == 1 ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_LINEAR_RGB;
    std::vector<uint16_t> read(numbers.values.size());
    ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr)) << image.message;
    EXPECT_EQ(read, numbers.values);
  }
}

TEST(Png, TruncationBeforeTheEndIsRefused) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(20, 20, 3));
  const std::string bytes = bytesOf(folder.file("a.png"));
  const size_t endOfPixels = bytes.size() - 12 - 4;  // the IEND chunk, the last CRC
  for (size_t length = 0; length < endOfPixels; length += 13) pngComplaint(bytes.substr(0, length));
}

TEST(Png, DamagedBytesNeverDoMoreThanThrow) {
  const test::ScratchFolder folder;
  writePng(folder.file("a.png"), noise(20, 20, 4));
  const std::string sound = bytesOf(folder.file("a.png"));
  Random random(9);
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string bytes = sound;
    for (int k = 0; k < 4; ++k)
      bytes[random.below(static_cast<uint32_t>(bytes.size()))] = static_cast<char>(random.next());
    putBytes(folder.file("b.png"), bytes);
    try {
      const Pixels8 pixels = readPng(folder.file("b.png"));
      EXPECT_EQ(pixels.bytes.size(), static_cast<size_t>(pixels.width * pixels.height * pixels.channels));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 30);
}

TEST(Png, FailedWritesNameTheFile) {
  const test::ScratchFolder folder;
  const std::string nowhere = folder.file("no/such/folder/a.png");
  EXPECT_THAT(test::messageOf<InputError>([&] { writePng(nowhere, noise(2, 2, 3)); }), HasSubstr(nowhere));
  EXPECT_THROW(writePng(folder.file("a.png"), Pixels8{}), InputError);
}

}  // namespace
}  // namespace loomlight
