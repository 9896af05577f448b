#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace loomlight {

/// Parses JSON that may come from anywhere. Throws InputError naming line and column for wrong syntax, and the place
/// for what is right JSON but no file of ours: nesting deeper than 64, a key given twice, millions of values.
nlohmann::json parseJson(std::string_view text, const std::string& source);

/// JSON on one line, or a key a line where an indentation is given. Names of files may be no UTF-8: what is none is
/// replaced.
template <class Json>
std::string jsonText(const Json& value, int indentation = -1) {
  return value.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

/// JSON as a person would lay it out: a key a line, lists of numbers on one line, lists of texts a text a line. Ends in
/// a newline. The same value always gives the same bytes.
std::string formatJson(const nlohmann::ordered_json& value);

}  // namespace loomlight
