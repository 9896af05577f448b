#include "core/fabric/model/field_path.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace loomlight {

std::string FieldPath::text() const {
  std::string text = parent_ ? parent_->text() : std::string();
  if (index_ >= 0) return text + fmt::format("[{}]", index_);
  if (!text.empty() && !key_.empty()) text += '.';
  return text + std::string(key_);
}

void FieldPath::reject(std::string_view expected, std::string_view got) const {
  const std::string where = text();
  throw InputError(
      fmt::format("{}: {}{}expected {}, got {}", source_, where, where.empty() ? "" : ": ", expected, got));
}

std::string plainText(std::string_view text) {
  constexpr size_t kLongest = 40;
  std::string shown;
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    shown += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  return text.size() > kLongest ? shown + "..." : shown;
}

std::string quotedText(std::string_view text) {
  return fmt::format("\"{}\"", plainText(text));
}

}  // namespace loomlight
