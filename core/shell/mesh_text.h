#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace loomlight {

/// Cuts a text into lines and lines into words, and knows where it is.
class MeshText {
 public:
  MeshText(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  /// Goes to the next line; false at the end of the text.
  bool nextLine() {
    if (next_ >= text_.size()) return false;
    ++number_;
    begin_ = next_;
    const size_t end = std::min(text_.find('\n', begin_), text_.size());
    next_ = end + 1;
    rest_ = text_.substr(begin_, end - begin_);
    return true;
  }
  /// The next word of the line; empty at its end.
  std::string_view word() {
    const size_t first = rest_.find_first_not_of(kBlank);
    if (first == std::string_view::npos) {
      rest_ = {};
      return {};
    }
    const size_t last = std::min(rest_.find_first_of(kBlank, first), rest_.size());
    const std::string_view found = rest_.substr(first, last - first);
    rest_.remove_prefix(last);
    return found;
  }
  size_t lineBegin() const { return begin_; }  ///< offset of the line in the text
  size_t nextBegin() const { return std::min(next_, text_.size()); }

  /// `expected` may quote the file, whatever is in it: what no terminal shows, or half a letter, is no help.
  [[noreturn]] void fail(std::string expected) const {
    for (char& c : expected)
      if (const auto byte = static_cast<unsigned char>(c); byte < 0x20 || byte >= 0x7F) c = '?';
    throw InputError(file_ + ":" + std::to_string(number_) + ": " + expected);
  }

 private:
  static constexpr std::string_view kBlank = " \t\r\v\f";
  std::string file_;
  std::string_view text_, rest_;
  size_t begin_ = 0, next_ = 0;
  size_t number_ = 0;
};

/// A coordinate: finite, and small enough for float.
inline std::optional<double> parseCoordinate(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !(std::abs(value) < 1e30)) return std::nullopt;
  return value;
}

inline std::optional<int64_t> parseInteger(std::string_view word) {
  int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace loomlight
