#pragma once

#include <string>

#include "app/export/handover/digital_cloth.h"

namespace loomlight {

/// A side of the cloth as a binary glTF 2.0, the bytes of a .glb: a flat swatch about 10 cm wide of whole tiles at true
/// size (metres), two-sided, with its pictures inside. Extensions: KHR_materials_specular, _sheen, _anisotropy,
/// _diffuse_transmission; none is required. A program without the last shows base colours brighter than the cloth is
/// in front of a dark ground, as they hold the light that goes through it too.
/// `scratch`: a file that may be made and is gone again. Throws InputError, naming `file`.
std::string glbBytes(const DigitalCloth& cloth, ClothSide side, const std::string& scratch, const std::string& file);
/// Throws InputError where so many bytes are more than a .glb can say that it has.
void expectGlbSize(size_t bytes, const std::string& file);

}  // namespace loomlight
