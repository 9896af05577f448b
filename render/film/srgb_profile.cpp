#include "render/film/srgb_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <memory>

namespace loomlight {

std::string sRgbProfile() {
  struct Close {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
  };
  const std::unique_ptr<void, Close> profile(cmsCreate_sRGBProfile());
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile.get(), nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile.get(), bytes.data(), &size);
  // When it was made is of no interest, and would make each file another one: the day of the standard in its place.
  constexpr std::array<char, 12> kMade = {0x07, static_cast<char>(0xCF), 0, 10, 0, 18, 0, 0, 0, 0, 0, 0};
  constexpr size_t kDate = 24;
  std::copy(kMade.begin(), kMade.end(), bytes.begin() + kDate);
  return bytes;
}

}  // namespace loomlight
