#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "render/film/film.h"
#include "render/film/fixed_point.h"

// How it works. The film becomes channels of an image, and is made of them again. A sum is split into parts that a
// float holds exactly, so that ordinary EXR channels carry it: 64 bits in three parts of 22, 22 and 20, signed 32
// bits in two parts of 16, lowest first. What is read is checked pixel by pixel: parts that are no such integers,
// and sums that so many samples cannot have, are damage. Cost: one pass over the channels.

namespace loomlight {
namespace {

const std::string kSumsKey = "loomlight.sums";
const std::string kSumsVersion = "2";          ///< counts up when quanta or channels change
const std::string kUnsignedSumsVersion = "1";  ///< the same, without colours outside of the gamut

std::array<float, 3> split(uint64_t v) {
  constexpr uint64_t mask = (1u << 22) - 1;
  return {static_cast<float>(v & mask), static_cast<float>(v >> 22 & mask), static_cast<float>(v >> 44)};
}
std::array<float, 3> split(int64_t v) {
  return split(static_cast<uint64_t>(v));
}
std::array<float, 2> split(int32_t v) {
  const auto bits = static_cast<uint32_t>(v);
  return {static_cast<float>(bits & 0xFFFF), static_cast<float>(bits >> 16)};
}
std::array<float, 1> split(uint32_t count) {
  return {static_cast<float>(count)};
}  // never above 2^24
std::array<float, 1> split(float v) {
  return {v};
}

/// Whether f is one of the integers 0 .. 2^bits - 1.
bool isPart(float f, int bits) {
  return f >= 0 && f < std::ldexp(1.0f, bits) && f == std::floor(f);
}

bool join(const std::array<float, 3>& parts, uint64_t& v) {
  if (!isPart(parts[0], 22) || !isPart(parts[1], 22) || !isPart(parts[2], 20)) return false;
  v = static_cast<uint64_t>(parts[0]) | static_cast<uint64_t>(parts[1]) << 22 | static_cast<uint64_t>(parts[2]) << 44;
  return true;
}
bool join(const std::array<float, 3>& parts, int64_t& v) {
  uint64_t bits = 0;
  const bool sound = join(parts, bits);
  v = static_cast<int64_t>(bits);
  return sound;
}
bool join(const std::array<float, 2>& parts, int32_t& v) {
  if (!isPart(parts[0], 16) || !isPart(parts[1], 16)) return false;
  v = static_cast<int32_t>(static_cast<uint32_t>(parts[0]) | static_cast<uint32_t>(parts[1]) << 16);
  return true;
}
bool join(const std::array<float, 1>& parts, uint32_t& count) {
  if (!isPart(parts[0], 24)) return false;
  count = static_cast<uint32_t>(parts[0]);
  return true;
}
bool join(const std::array<float, 1>& parts, float& v) {
  v = parts[0];
  return true;
}

std::string partName(const char* sum, size_t part, size_t parts) {
  return parts == 1 ? fmt::format("sum.{}", sum) : fmt::format("sum.{}.{}", sum, part);
}

const std::vector<float>& channel(const Image& image, const std::string& name, const std::string& file) {
  const Image::Channel* found = image.find(name);
  if (!found) throw InputError(fmt::format("{}: no channel '{}': it cannot be resumed", file, name));
  return found->values;
}

float meanOver(double sum, double quantum, uint32_t count) {
  return count == 0 ? 0.0f : static_cast<float>(sum * quantum / count);
}

}  // namespace

/// Calls visit(name, sum) for whatever the picture's own channels do not hold exactly already.
template <class P, class Visit>
void Film::visitSums(P& p, Visit&& visit) {
  visit("direct.R", p.direct[0]);
  visit("direct.G", p.direct[1]);
  visit("direct.B", p.direct[2]);
  visit("indirect.R", p.indirect[0]);
  visit("indirect.G", p.indirect[1]);
  visit("indirect.B", p.indirect[2]);
  visit("luminance2", p.luminance2);
  visit("depth", p.depth);
  visit("events", p.events);
  visit("normal.X", p.normal[0]);
  visit("normal.Y", p.normal[1]);
  visit("normal.Z", p.normal[2]);
  visit("tangent.X", p.tangent[0]);
  visit("tangent.Y", p.tangent[1]);
  visit("tangent.Z", p.tangent[2]);
  visit("samples", p.samples);
  visit("hits", p.hits);
  visit("firstIndex", p.firstIndex);
  visit("hitDepth", p.hitDepth);
}

Image Film::toImage(bool withSums) const {
  Image image;
  image.width = width_;
  image.height = height_;
  static constexpr std::array own{
      "R",          "G",          "B",          "A",       "direct.R",     "direct.G",      "direct.B",
      "indirect.R", "indirect.G", "indirect.B", "depth.Z", "normal.X",     "normal.Y",      "normal.Z",
      "tangent.X",  "tangent.Y",  "tangent.Z",  "yarn.id", "crossing.end", "crossing.pick", "variance.Y"};
  for (const char* name : own) image.add(name);
  if (withSums) {
    image.metadata[kSumsKey] = kSumsVersion;
    const Pixel none{};
    visitSums(none, [&](const char* name, auto sum) {
      const size_t parts = split(sum).size();
      for (size_t i = 0; i < parts; ++i) image.add(partName(name, i, parts));
    });
  }
  parallelFor(static_cast<size_t>(height_), 0, [&](size_t row) {
    for (size_t i = row * static_cast<size_t>(width_); i < (row + 1) * static_cast<size_t>(width_); ++i) {
      const Pixel& p = pixels_[i];
      size_t next = 0;
      const auto put = [&](float value) { image.channels[next++].values[i] = value; };
      const Rgb radiance = mean(p);
      for (int c = 0; c < 3; ++c) put(radiance[c]);
      put(meanOver(p.hits, 1, p.samples));
      for (const int64_t sum : p.direct) put(meanOver(static_cast<double>(sum), kRadianceQuantum, p.samples));
      for (const int64_t sum : p.indirect) put(meanOver(static_cast<double>(sum), kRadianceQuantum, p.samples));
      put(meanDepth_mm(p));
      for (const int32_t sum : p.normal) put(meanOver(sum, kDirectionQuantum, p.hits));
      for (const int32_t sum : p.tangent) put(meanOver(sum, kDirectionQuantum, p.hits));
      const Hit first = hit(p);
      for (const int id : {first.yarn, first.end, first.pick}) put(static_cast<float>(id));
      put(variance(p));
      if (!withSums) continue;
      visitSums(p, [&](const char*, auto sum) {
        for (const float part : split(sum)) put(part);
      });
    }
  });
  return image;
}

Film Film::fromImage(const Image& image, const std::string& file) {
  const auto version = image.metadata.find(kSumsKey);
  if (version == image.metadata.end()) throw InputError(fmt::format("{}: holds no sums, it cannot be resumed", file));
  if (version->second != kSumsVersion && version->second != kUnsignedSumsVersion)
    throw InputError(fmt::format("{}: sums of version {}, expected {}", file, version->second, kSumsVersion));

  Film film(image.width, image.height);
  const std::array<const std::vector<float>*, 3> ids{
      &channel(image, "yarn.id", file), &channel(image, "crossing.end", file), &channel(image, "crossing.pick", file)};
  std::vector<const std::vector<float>*> sums;
  visitSums(film.pixels_[0], [&](const char* name, auto sum) {
    const size_t parts = split(sum).size();
    for (size_t i = 0; i < parts; ++i) sums.push_back(&channel(image, partName(name, i, parts), file));
  });
  for (size_t i = 0; i < film.pixels_.size(); ++i) {
    Pixel& p = film.pixels_[i];
    size_t next = 0;
    bool sound = true;
    visitSums(p, [&](const char*, auto& sum) {
      auto parts = split(sum);
      for (float& part : parts) part = (*sums[next++])[i];
      sound = join(parts, sum) && sound;
    });
    sound = sound && p.samples <= maxSamples && p.hits <= p.samples;
    const int64_t brightest = p.samples * static_cast<int64_t>(kMaxRadiance / kRadianceQuantum);
    for (const int64_t sum : {p.direct[0], p.direct[1], p.direct[2], p.indirect[0], p.indirect[1], p.indirect[2]})
      sound = sound && sum >= -brightest && sum <= brightest;
    const int64_t longest = p.hits * static_cast<int64_t>(1 / kDirectionQuantum);
    for (int c = 0; c < 3; ++c)
      sound = sound && std::abs(int64_t{p.normal[c]}) <= longest && std::abs(int64_t{p.tangent[c]}) <= longest;
    if (p.hits > 0) {
      std::array<int32_t*, 3> own{&p.yarn, &p.end, &p.pick};
      for (size_t k = 0; k < own.size(); ++k) {
        const float id = (*ids[k])[i];
        sound = sound && id >= -1 && id <= 0x1p24f && id == std::floor(id);
        if (sound) *own[k] = static_cast<int32_t>(id);
      }
    }
    if (!sound)
      throw InputError(fmt::format("{}: the sums of pixel {}, {} are damaged", file,
                                   i % static_cast<size_t>(image.width), i / static_cast<size_t>(image.width)));
  }
  return film;
}

}  // namespace loomlight
