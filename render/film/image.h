#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace loomlight {

constexpr int kMaxSide = 16384;  ///< the longest side of a picture, pixels

/// Named float channels over one rectangle, row by row from the top left; the in-memory form of an EXR.
struct Image {
  struct Channel {
    std::string name;           ///< EXR names: R, G, B, A, depth.Z, normal.X ...
    std::vector<float> values;  ///< width * height
  };
  int width = 0, height = 0;
  /// Of a part of a larger picture: where its top left lies in that one, and how large that is; 0 x 0 where it is
  /// whole. In an EXR, its data window in its display window.
  int left = 0, top = 0, wholeWidth = 0, wholeHeight = 0;
  std::vector<Channel> channels;
  std::map<std::string, std::string> metadata;

  const Channel* find(const std::string& name) const;
  std::vector<float>& add(std::string name);  ///< zero-filled; the reference is good until the next add
};

struct PictureExtent {
  int width = 0, height = 0, channels = 0;
};

/// Throw InputError, naming the file and what is wrong with it. Writers write a temporary file beside the target and
/// rename it, so that a picture is whole or the old one is still there. Sizes beyond 16384 x 16384 are refused. An EXR
/// with channels R, G and B says that they are of Rec. 709, white D65.
Image readExr(const std::string& file);
/// Only how large it says it is.
PictureExtent readExrExtent(const std::string& file);
/// Only its metadata.
std::map<std::string, std::string> readExrTexts(const std::string& file);
PictureExtent readPngExtent(const std::string& file);
/// `dpi`: pixels per inch, which is how large it is on paper; 0 where it has no size of its own.
void writeExr(const std::string& file, const Image& image, double dpi = 0);

/// 8-bit RGB or RGBA, sRGB-encoded by the caller.
struct Pixels8 {
  int width = 0, height = 0, channels = 4;
  std::vector<uint8_t> bytes;
};
/// The byte that a channel from 0 to 1 becomes; beyond, the nearest there is.
inline uint8_t byteOf(float channel) {
  return static_cast<uint8_t>(std::lround(255 * std::clamp(channel, 0.0f, 1.0f)));
}
/// How many pixels an inch has, across and down, which is how large a picture is on paper; 0 where it has no size of
/// its own. The two differ where a tile of cloth is a whole number of pixels both ways.
struct PixelDensity {
  PixelDensity(double dpi = 0) : across_dpi(dpi), down_dpi(dpi) {}
  PixelDensity(double across, double down) : across_dpi(across), down_dpi(down) {}
  double across_dpi, down_dpi;
};
void writePng(const std::string& file, const Pixels8& pixels, const std::map<std::string, std::string>& text = {},
              PixelDensity density = {});
/// `texts`: if wanted, those in it that writePng() can write: UTF-8, not compressed.
Pixels8 readPng(const std::string& file, std::map<std::string, std::string>* texts = nullptr);

/// Numbers of 16 bits, which are no colours: 1 or 3 channels.
struct Pixels16 {
  int width = 0, height = 0, channels = 1;
  std::vector<uint16_t> values;
};
void writePng(const std::string& file, const Pixels16& pixels, PixelDensity density = {});

}  // namespace loomlight
