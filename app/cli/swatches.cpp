#include "app/cli/swatches.h"

#include <fmt/format.h>

#include <cstdio>

namespace loomlight {

MeasuredSwatch swatchFrom(const std::string& file) {
  SwatchFile found = readSwatches(file);
  for (const std::string& remark : found.remarks) fmt::print(stderr, "{}: {}\n", file, remark);
  if (found.swatches.size() > 1)
    fmt::print(stderr, "{}: the first of {} swatches is taken, '{}'\n", file, found.swatches.size(),
               found.swatches.front().name);
  return std::move(found.swatches.front());
}

Spectrum reflectanceFrom(const std::string& file) {
  return bandReflectance(swatchFrom(file));
}

}  // namespace loomlight
