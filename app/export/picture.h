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
/// can be rendered again from itself; the bytes depend on the arguments alone. `.png`: as the display shows it.
/// `keepSums` adds to an .exr the film's exact sums, from which it can be continued; `dpi` is its size on paper, 0 for
/// none. Throws InputError when the file cannot be written.
void writePicture(const std::string& file, const Film& film, const Fabric& fabric, const Tone& tone, bool keepSums,
                  double dpi = 0);

/// The texts that our .png files of a fabric carry.
std::map<std::string, std::string> pngTexts(const Fabric& fabric);

/// The fabric and settings in the metadata of an .exr of ours. Throws InputError when there are none.
Fabric fabricOfPicture(const std::string& file);

/// Samples that every pixel has at least.
uint32_t fewestSamples(const Film& film);

/// A picture to be continued: its film, in which every pixel holds its own first samples, and its fabric.
struct UnfinishedPicture {
  Fabric fabric;
  Film film;
};

/// Reads an .exr written with `keepSums`, a finished one or a stopped one. Throws InputError when it holds no sums.
UnfinishedPicture readUnfinishedPicture(const std::string& file);

}  // namespace loomlight
