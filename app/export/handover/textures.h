#pragma once

#include <string>
#include <vector>

#include "app/export/file_set.h"
#include "app/export/handover/digital_cloth.h"

namespace loomlight {

/// The pictures of a side, as names of files within the folder of the hand-over: textures/NAME_BASE.png.
struct SideTextures {
  std::string base;                ///< sRGB: diffuse light sent back
  std::string transmitted;         ///< sRGB: diffuse light let through
  std::string normal;              ///< 16 bits, y up (OpenGL)
  std::string height;              ///< 16 bits: black is lowest_mm, white highest_mm
  std::string roughness;           ///< 16 bits, as Disney's surface has it (side_pixels.h)
  std::string anisotropy;          ///< likewise
  std::string anisotropyRotation;  ///< 16 bits: rotationOf()
  std::string opacity;             ///< 16 bits
  float lowest_mm = 0, highest_mm = 0;
  /// What a program takes that reads no pictures: means over the tile.
  struct Means {
    Rgb base{0};          ///< linear
    float height = 0.5f;  ///< from lowest_mm, 0, to highest_mm, 1
    float opacity = 1, roughness = 1, anisotropy = 0, anisotropyRotation = 0.5f;
  } means;

  std::vector<std::string> files() const {
    return {base, transmitted, normal, height, roughness, anisotropy, anisotropyRotation, opacity};
  }
};

/// The names that they will have, without anything of what is in them.
SideTextures namesOfTextures(const std::string& name, ClothSide side);

/// Adds them to `set`, in a folder "textures". All have three channels, as U3M asks for, and the size of the tile as
/// dots per inch. When stopped, some of them are not there. Throws InputError.
SideTextures writeTextures(FileSet& set, const std::string& name, const DigitalCloth& cloth, ClothSide side,
                           const Task& task);

}  // namespace loomlight
