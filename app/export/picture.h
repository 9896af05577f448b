#pragma once

#include <map>
#include <string>

#include "core/fabric/model/fabric.h"
#include "render/colour/tone.h"
#include "render/film/film.h"

namespace loomlight {

/// Throws InputError unless the name ends in an extension that writePicture() can write, and the file can be written
/// where it is to be. Called before long work, so that a slip in the name costs nothing.
void checkPictureName(const std::string& file);

/// Writes a film as a picture; the file is whole or the old one is still there. `.exr`: linear light, every AOV, and
/// as metadata the fabric with all its settings, the samples per pixel and the program's version, so that the picture
/// can be rendered again from itself; the bytes depend on the arguments alone. `.png`: as the display shows it. `dpi`
/// is its size on paper, 0 for none. Throws InputError when the file cannot be written.
void writePicture(const std::string& file, const Film& film, const Fabric& fabric, const Tone& tone, double dpi = 0);

/// The texts that our .png files of a fabric carry.
std::map<std::string, std::string> pngTexts(const Fabric& fabric);

/// The metadata of our .exr files, as `file` is to hold it.
std::map<std::string, std::string> exrTexts(const Film& film, const Fabric& fabric, const std::string& file);
/// The fabric and settings in it. Throws InputError when there are none.
Fabric fabricInTexts(const std::map<std::string, std::string>& texts, const std::string& file);
/// Those of an .exr of ours.
Fabric fabricOfPicture(const std::string& file);

}  // namespace loomlight
