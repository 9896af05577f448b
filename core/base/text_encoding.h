#pragma once

#include <string>
#include <string_view>

namespace loomlight {

enum class TextEncoding { utf8, utf16, windows1252 };

struct DecodedText {
  std::string text;  ///< UTF-8, always valid
  TextEncoding encoding = TextEncoding::utf8;
};

/// The text in bytes whose encoding nobody stated, as old files come: UTF-8 or UTF-16 by their marks, or by what they
/// look like; what is neither is Windows-1252, the Latin-1 of Windows programs, in which every byte means something.
/// A UTF-16 surrogate without its partner becomes U+FFFD; the Ctrl+Z and zeros that end files of DOS are left out.
/// Throws InputError, naming `source`, for bytes that are no text: a zero among them.
DecodedText decodeText(std::string_view bytes, const std::string& source);

/// Takes the next line off the text, without its end, which is \n, \r\n or \r.
std::string_view takeLine(std::string_view& text);

}  // namespace loomlight
