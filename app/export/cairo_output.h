#pragma once

#include <cairo.h>

#include <string>

namespace loomlight {

/// A cairo_write_func_t that appends what cairo writes to the std::string at `text`.
cairo_status_t appendTo(void* text, const unsigned char* data, unsigned int length);

/// Throws InputError that `what` could not be drawn into the file, unless all went well, or the surface is finished.
void expectDrawn(cairo_status_t status, const std::string& file, const char* what);

}  // namespace loomlight
