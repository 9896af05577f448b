#pragma once

#include <string>
#include <vector>

#include "app/export/sample_box.h"
#include "core/fabric/model/fabric.h"
#include "render/film/film.h"

namespace loomlight {

/// What a picture says that a processor of one kind began, and one of another went on with.
inline constexpr const char* kSeveralKinds = "several";

/// What the samples of a picture depend on beside its fabric and settings. Empty where there is none, or none was said.
struct SampleOrigin {
  std::string program;      ///< the build that traced them
  std::string fibres;       ///< which of them were laid; this may depend on the memory of the machine
  std::string mesh;         ///< a digest of the drape's file
  std::string environment;  ///< a digest of the light's file
  std::string lamp;         ///< a digest of the file with its lamps' spectrum
  /// The kind of processor that shows in their last bits: of the rays in a tree of fibres (processorKind()), or of the
  /// report's tables of visibility. Empty where every processor traces the same; kSeveralKinds.
  std::string processor;
  bool operator==(const SampleOrigin&) const = default;
};

/// What an .exr with sums says of itself: enough to go on with it, and to merge it with others.
struct PartInfo {
  Fabric fabric;  ///< with the settings of the whole picture, its samples per pixel among them
  SampleOrigin origin;
  std::vector<SampleBox> boxes;  ///< the samples that it holds, or is to hold: at least one box, no two overlap
};

/// A picture, or a part of it: the film has the pixels of the window, with those samples that are traced so far.
struct PicturePart {
  PartInfo info;
  PixelRect window;
  Film film;
};

/// The most boxes that a file may name, and that are merged.
inline constexpr size_t kMaxSampleBoxes = 16384;

/// The program and the files of a fabric. Throws InputError where one cannot be read.
SampleOrigin originOf(const Fabric& fabric, const std::string& program, const std::string& fibres);

/// SampleOrigin::processor of a picture to which samples are added.
std::string withKind(const std::string& before, const std::string& added);

/// Writes the exact sums of what the boxes hold of a picture: an .exr with the same layers as writePicture() gives it,
/// whose data window is that of the boxes in the whole picture; whole, or the old one is still there. `film` is of the
/// whole picture. Throws InputError when it cannot be written.
void writePart(const std::string& file, const Film& film, const PartInfo& info);

/// Throw InputError when the file holds no sums, or what it says of itself is damaged. Of an .exr by a program that did
/// not say which samples it holds, they are the first ones of all pixels, of unknown origin.
PartInfo readPartInfo(const std::string& file);
PicturePart readPart(const std::string& file);

/// Throws InputError, which names both files, unless the samples are of the same picture: the same fabric with the same
/// settings, but for how many samples it is to have.
void expectSameFabric(const Fabric& wanted, const std::string& wantedFile, const Fabric& other,
                      const std::string& otherFile);
/// Likewise, unless they are by the same program, of the same fibres, and of files with the same content.
void expectSameOrigin(const SampleOrigin& wanted, const std::string& wantedFile, const SampleOrigin& other,
                      const std::string& otherFile);
/// Likewise, where `other` shows several kinds of processors, or both show one and these differ.
void expectSameProcessor(const SampleOrigin& wanted, const std::string& wantedFile, const SampleOrigin& other,
                         const std::string& otherFile);

}  // namespace loomlight
