#pragma once

#include <cairo.h>

#include <string>

#include "core/base/units.h"
#include "render/film/image.h"

namespace loomlight {

/// Points, the unit of cairo's pages, in a millimetre.
inline constexpr double kPointsPerMm = 72 / kMmPerInch;

/// A cairo_write_func_t that appends what cairo writes to the std::string at `text`.
cairo_status_t appendTo(void* text, const unsigned char* data, unsigned int length);

/// What cairo has drawn on a picture of CAIRO_FORMAT_RGB24, in three channels.
Pixels8 pixelsOf(cairo_surface_t* picture);

/// Throws InputError that `what` could not be drawn into the file, unless all went well, or the surface is finished.
void expectDrawn(cairo_status_t status, const std::string& file, const char* what);

}  // namespace loomlight
