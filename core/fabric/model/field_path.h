#pragma once

#include <string>
#include <string_view>

namespace loomlight {

/// The path of a field in a fabric or in a file of one, for messages: `samples/x.json: yarns[1].plies`. Cheap to make,
/// since the text is only put together when something is wrong there.
class FieldPath {
 public:
  explicit FieldPath(std::string_view source) : source_(source) {}
  FieldPath at(std::string_view key) const { return FieldPath(this, key, -1); }
  FieldPath at(size_t index) const { return FieldPath(this, {}, static_cast<long>(index)); }

  /// `yarns[1].plies`; empty for the whole file.
  std::string text() const;
  /// Throws InputError: `source: path: expected <expected>, got <got>`.
  [[noreturn]] void reject(std::string_view expected, std::string_view got) const;

 private:
  FieldPath(const FieldPath* parent, std::string_view key, long index)
      : source_(parent->source_), parent_(parent), key_(key), index_(index) {}

  std::string_view source_;
  const FieldPath* parent_ = nullptr;  ///< outlives this one: paths are only made on the way down
  std::string_view key_;
  long index_ = -1;
};

/// Text from outside, fit for a message: one line, ASCII, no control characters, cut to a sensible length.
std::string plainText(std::string_view text);
/// The same in quotes.
std::string quotedText(std::string_view text);

}  // namespace loomlight
