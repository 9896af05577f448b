#pragma once

#include <lcms2.h>

#include <string>

/// Colour profiles of devices that there are not, made for tests.
namespace loomlight::test {

/// Of a profile, which is closed.
inline std::string savedBytes(cmsHPROFILE profile) {
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

inline constexpr cmsCIExyY kD65 = {0.3127, 0.3290, 1};
inline constexpr cmsCIExyYTRIPLE kRec709 = {{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
inline constexpr cmsCIExyYTRIPLE kAdobe = {{0.64, 0.33, 1}, {0.21, 0.71, 1}, {0.15, 0.06, 1}};

/// A device of three primaries and a power for a tone curve.
inline cmsHPROFILE threePrimaries(const cmsCIExyYTRIPLE& primaries, double gamma, cmsProfileClassSignature kind) {
  cmsToneCurve* const curve = cmsBuildGamma(nullptr, gamma);
  cmsToneCurve* const curves[] = {curve, curve, curve};
  cmsHPROFILE profile = cmsCreateRGBProfile(&kD65, &primaries, curves);
  cmsFreeToneCurve(curve);
  cmsSetDeviceClass(profile, kind);
  return profile;
}

/// Of a printer with primaries of Rec. 709 drawn to white by a third: no ink is as pure as light.
inline std::string palePrinterProfile() {
  const auto paler = [](const cmsCIExyY& of) {
    return cmsCIExyY{of.x + (kD65.x - of.x) / 3, of.y + (kD65.y - of.y) / 3, 1};
  };
  const cmsCIExyYTRIPLE pale = {paler(kRec709.Red), paler(kRec709.Green), paler(kRec709.Blue)};
  return savedBytes(threePrimaries(pale, 2.2, cmsSigOutputClass));
}

}  // namespace loomlight::test
