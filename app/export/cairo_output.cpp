#include "app/export/cairo_output.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace loomlight {

cairo_status_t appendTo(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void expectDrawn(cairo_status_t status, const std::string& file, const char* what) {
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
    throw InputError(fmt::format("{}: expected to draw {}, got: {}", file, what, cairo_status_to_string(status)));
}

}  // namespace loomlight
