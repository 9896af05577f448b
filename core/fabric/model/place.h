#pragma once

#include <string>
#include <string_view>

namespace loomlight {

/// A place in a fabric or in a file of one, for messages: `samples/x.json: yarns[1].plies`. Cheap to make, since the
/// path is only put together when something is wrong there.
class Place {
 public:
  explicit Place(std::string_view source) : source_(source) {}
  Place at(std::string_view key) const { return Place(this, key, -1); }
  Place at(size_t index) const { return Place(this, {}, static_cast<long>(index)); }

  /// `yarns[1].plies`; empty for the whole file.
  std::string path() const;
  /// Throws InputError: `source: path: expected <expected>, got <got>`.
  [[noreturn]] void reject(std::string_view expected, std::string_view got) const;

 private:
  Place(const Place* parent, std::string_view key, long index)
      : source_(parent->source_), parent_(parent), key_(key), index_(index) {}

  std::string_view source_;
  const Place* parent_ = nullptr;  ///< outlives this one: places are only made on the way down
  std::string_view key_;
  long index_ = -1;
};

/// Text from outside, fit for a message: one line, ASCII, no control characters, cut to a sensible length.
std::string plainText(std::string_view text);
/// The same in quotes.
std::string quotedText(std::string_view text);

}  // namespace loomlight
