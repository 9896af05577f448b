#pragma once

#include "app/export/handover/digital_cloth.h"

namespace loomlight {

/// What formats write of a pixel of a fitted side: numbers from 0 to 1, colours linear.
struct SidePixel {
  Rgb reflected{0};    ///< diffuse, as fitted
  Rgb transmitted{0};  ///< diffuse, as fitted
  float opacity = 1;
  glm::vec3 normal{0, 0, 1};
  glm::vec2 drawnOut{1, 0};  ///< the axis along which highlights are long: across the fibres; unit
  float roughness = 1;       ///< as glTF has it: across the axis
  float anisotropy = 0;      ///< as glTF has it
};
SidePixel sidePixel(const DigitalSide& side, size_t pixel);

/// The rotation of the axis from the picture's x towards its y, as a share of a full turn. An axis has two ends: that
/// one is taken which lies between 135 and 315 degrees, so that axes near x (0.5) and y (0.75), where those of warp and
/// weft are, never jump from 1 to 0 between two pixels, and programs may filter them.
float rotationOf(glm::vec2 drawnOut);

/// Roughness and anisotropy as Disney's principled surface has them (Burley 2012), which U3M and Blender follow: slopes
/// r^2 / q and r^2 q with q = sqrt(1 - 0.9 anisotropy).
struct DisneyGloss {
  float roughness = 1, anisotropy = 0;
};
DisneyGloss disneyGloss(float roughness, float anisotropy);

/// The same as OpenPBR has them: slopes r^2 sqrt(2 / (1 + (1 - anisotropy)^2)), and (1 - anisotropy) times that.
DisneyGloss openPbrGloss(float roughness, float anisotropy);

/// How strong a gloss is in a model with another Fresnel than glTF's, which is that of glass times `specular` at every
/// angle: so that its albedo is nearest to glTF's in all views.
struct GlossStrength {
  float value = 0;     ///< 0..1
  float rmsError = 0;  ///< of the albedo, by projected solid angle, over views
};
/// Of Disney's: Schlick's from 0.08 value at the normal to 1 at grazing, however small the value; glass has 0.5.
GlossStrength disneySpecular(const Principled& surface);
/// Of OpenPBR's specular_weight: Fresnel's equations for a body that reflects 0.04 value at the normal; glass has 1.
GlossStrength openPbrSpecular(const Principled& surface);

/// The sheen as Disney's surface has it, which has no roughness: `value` times Schlick's (1 - cos)^5 of the angle
/// between light and half vector, white. The value is that for which its albedo is nearest to glTF's in all views.
struct DisneySheen {
  float value = 0;     ///< 0..1
  float rmsError = 0;  ///< of the albedo, over channels and, by projected solid angle, views
};
DisneySheen disneySheen(const Principled& surface);

/// A cloth's light through it, as glTF and OpenPBR split it from what comes back: `share` of the diffuse light goes
/// through, and is of `through`; the rest is of `base`. The share is no larger than what the brightest channel needs.
struct SplitColour {
  Rgb base{0}, through{1};
  float share = 0;
};
SplitColour splitColour(const Rgb& reflected, const Rgb& transmitted);

}  // namespace loomlight
