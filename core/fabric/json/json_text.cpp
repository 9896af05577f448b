#include "core/fabric/json/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/fabric/model/field_path.h"

// How it works. nlohmann's parser reads twice. The first time a guard hears of each list, object, key and value as it
// is met, and refuses what the parser would take: depths above 64, millions of values, a key given twice. It keeps one
// level for each list or object that is open, from which it puts the path together once something is wrong. The second
// time the value is made. (The parser can do both at once, but then looks through all elements of a list whenever one
// of them ends: a list of a million would take it hours.) Writing is a recursion over the value. Cost: linear in the
// text; a look-up in a tree for each key.

namespace loomlight {
namespace {

constexpr size_t kMaxDepth = 64;
/// A value takes up to some 100 bytes, whatever it is: a file of 280 million commas must not need 30 GB.
constexpr size_t kMaxValues = 5'000'000;
constexpr size_t kMaxKeys = 4096;

/// Hears of all that the parser meets and refuses what it would accept: it knows no limits, and lets the last of two
/// equal keys win.
class Guard : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Guard(const std::string& source) : source_(source) {}

  bool null() override { return countValue(); }
  bool boolean(bool) override { return countValue(); }
  bool number_integer(number_integer_t) override { return countValue(); }
  bool number_unsigned(number_unsigned_t) override { return countValue(); }
  bool number_float(number_float_t, const string_t&) override { return countValue(); }
  bool string(string_t&) override { return countValue(); }
  bool binary(binary_t&) override { return countValue(); }
  bool start_object(size_t) override { return open(); }
  bool start_array(size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& key) override {
    addKey(key);
    return true;
  }
  bool parse_error(size_t, const std::string&, const nlohmann::json::exception& error) override {
    constexpr int kNumberOutOfRange = 406;
    if (error.id == kNumberOutOfRange) refuseNumber();
    return false;
  }

 private:
  /// The value that comes now, which the parser has not taken: the only one that is written well and still is none.
  [[noreturn]] void refuseNumber() {
    countValue();
    refuse("a number within the range of floating point", "one beyond it");
  }

  struct Level {
    std::set<std::string, std::less<>> keys;
    const std::string* key = nullptr;  ///< the last one; null in a list
    size_t values = 0;
  };

  bool countValue() {
    if (++values_ > kMaxValues) refuse(fmt::format("at most {} values", kMaxValues), "more");
    if (!open_.empty()) ++open_.back().values;
    return true;
  }

  bool open() {
    countValue();
    if (open_.size() >= kMaxDepth) refuse(fmt::format("lists and objects nested at most {} deep", kMaxDepth), "more");
    open_.emplace_back();
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  void addKey(const std::string& key) {
    Level& level = open_.back();
    const auto [position, isNew] = level.keys.insert(key);
    level.key = &*position;
    if (!isNew) refuse("every key once", "it twice");
    if (level.keys.size() > kMaxKeys) refuse(fmt::format("at most {} keys", kMaxKeys), "more");
  }

  [[noreturn]] void refuse(const std::string& expected, const char* got) const {
    std::string path;
    for (const Level& level : open_) {
      if (level.key) {
        if (!path.empty()) path += '.';
        path += plainText(*level.key);
      } else if (level.values > 0) {
        path += fmt::format("[{}]", level.values - 1);
      }
      if (path.size() > 200) {
        path += "...";
        break;
      }
    }
    throw InputError(
        fmt::format("{}: {}{}expected {}, got {}", source_, path, path.empty() ? "" : ": ", expected, got));
  }

  const std::string& source_;
  std::vector<Level> open_;
  size_t values_ = 0;
};

/// The heart of the parser's complaint, printable, and not as long as what it chokes on.
std::string complaint(const char* what) {
  std::string_view text(what);
  if (const size_t id = text.find("] "); id != std::string_view::npos) text.remove_prefix(id + 2);
  constexpr std::string_view kHead = "syntax error while parsing ";
  if (const size_t at = text.find(kHead); at != std::string_view::npos) text.remove_prefix(at + kHead.size());
  text = text.substr(0, text.find("; "));
  std::string shown;
  for (const char c : text.substr(0, 200)) shown += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  return text.size() > 200 ? shown + "..." : shown;
}

InputError syntaxError(std::string_view text, const std::string& source, const nlohmann::json::parse_error& error) {
  // `byte` counts what was read, so it names the byte after the last good one; at the end of the text it is one too
  // far.
  const size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
  const std::string_view before = text.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const size_t lineStart = before.rfind('\n');
  const size_t column = lineStart == std::string_view::npos ? at + 1 : at - lineStart;
  const char* const what = at == text.size() ? "the text breaks off" : "this is no JSON";
  return InputError(
      fmt::format("{}: line {}, column {}: {} ({})", source, line, column, what, complaint(error.what())));
}

using Json = nlohmann::ordered_json;

std::string scalar(const Json& value) {
  return jsonText(value);
}

bool isShortList(const Json& list) {
  return std::all_of(list.begin(), list.end(),
                     [](const Json& v) { return v.is_primitive() ? !v.is_string() : v.is_array() && isShortList(v); });
}

void append(std::string& out, const Json& value, size_t indent) {
  const auto newLine = [&](size_t depth) { out.append("\n").append(2 * depth, ' '); };
  if (value.is_array() && isShortList(value)) {
    out += '[';
    for (size_t i = 0; i < value.size(); ++i) {
      if (i > 0) out += ", ";
      append(out, value[i], indent);
    }
    out += ']';
  } else if (value.is_array()) {
    out += '[';
    for (size_t i = 0; i < value.size(); ++i) {
      if (i > 0) out += ',';
      newLine(indent + 1);
      append(out, value[i], indent + 1);
    }
    newLine(indent);
    out += ']';
  } else if (value.is_object() && !value.empty()) {
    out += '{';
    bool first = true;
    for (auto item = value.begin(); item != value.end(); ++item) {
      if (!first) out += ',';
      first = false;
      newLine(indent + 1);
      out += scalar(Json(item.key()));
      out += ": ";
      append(out, item.value(), indent + 1);
    }
    newLine(indent);
    out += '}';
  } else {
    out += scalar(value);
  }
}

}  // namespace

nlohmann::json parseJson(std::string_view text, const std::string& source) {
  Guard guard(source);
  nlohmann::json::sax_parse(text.begin(), text.end(), &guard);
  try {
    return nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::parse_error& error) {
    throw syntaxError(text, source, error);
  }
}

std::string formatJson(const nlohmann::ordered_json& value) {
  std::string out;
  append(out, value, 0);
  return out + '\n';
}

}  // namespace loomlight
