#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "core/base/hash.h"
#include "core/base/random.h"
#include "render/film/film.h"

namespace loomlight::test {

/// Anything a tracer could bring back; a third of the samples miss the cloth.
inline PathSample randomSample(Random& random) {
  PathSample s;
  s.direct = {random.uniform(), 10 * random.uniform(), 1e-3f * random.uniform()};
  s.indirect = {random.uniform(), 1e4f * random.uniform(), random.uniform()};
  s.events = random.below(100);
  if (random.uniform() < 0.33f) return s;
  s.alpha = 1;
  s.depth_mm = 100 * random.uniform();
  s.normal = glm::normalize(glm::vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() + 0.1f));
  s.tangent = glm::normalize(glm::vec3(random.uniform() - 0.5f, random.uniform() + 0.1f, random.uniform() - 0.5f));
  s.yarn = static_cast<int>(random.below(64));
  s.end = static_cast<int>(random.below(100000));
  s.pick = static_cast<int>(random.below(100000));
  return s;
}

/// Samples of these numbers for every pixel; sample i of a pixel is always the same.
inline void addAll(Film& film, const std::vector<uint32_t>& indices) {
  for (const uint32_t index : indices) {
    for (int y = 0; y < film.height(); ++y) {
      for (int x = 0; x < film.width(); ++x) {
        Random random(hashCombine(hashCombine(static_cast<uint64_t>(x), static_cast<uint64_t>(y)), index));
        film.add(x, y, index, randomSample(random));
      }
    }
  }
}

inline void expectSameImage(const Image& a, const Image& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (const Image::Channel& channel : a.channels) {
    const Image::Channel* other = b.find(channel.name);
    ASSERT_NE(other, nullptr) << channel.name;
    for (size_t i = 0; i < channel.values.size(); ++i)
      ASSERT_EQ(std::bit_cast<uint32_t>(channel.values[i]), std::bit_cast<uint32_t>(other->values[i]))
          << channel.name << " of pixel " << i << ": " << channel.values[i] << " and " << other->values[i];
  }
}

inline void expectSameSums(const Film& a, const Film& b) {
  expectSameImage(a.toImage(true), b.toImage(true));
}

}  // namespace loomlight::test
