#include "app/export/sheet/cairo_output.h"

#include <fmt/format.h>

#include <cstdint>

#include "core/base/error.h"

namespace loomlight {

cairo_status_t appendTo(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Pixels8 pixelsOf(cairo_surface_t* picture) {
  cairo_surface_flush(picture);
  Pixels8 pixels{cairo_image_surface_get_width(picture), cairo_image_surface_get_height(picture), 3, {}};
  pixels.bytes.reserve(3 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
  const unsigned char* const rows = cairo_image_surface_get_data(picture);
  const ptrdiff_t stride = cairo_image_surface_get_stride(picture);
  for (int row = 0; row < pixels.height; ++row) {
    const auto* const in = reinterpret_cast<const uint32_t*>(rows + row * stride);
    for (int column = 0; column < pixels.width; ++column)
      for (const int shift : {16, 8, 0}) pixels.bytes.push_back(static_cast<uint8_t>(in[column] >> shift & 0xFF));
  }
  return pixels;
}

void expectDrawn(cairo_status_t status, const std::string& file, const char* what) {
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
    throw InputError(fmt::format("{}: expected to draw {}, got: {}", file, what, cairo_status_to_string(status)));
}

}  // namespace loomlight
