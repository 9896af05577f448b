#include "core/fabric/json/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "core/base/error.h"

// How it works. nlohmann's parser reads; a guard hears of each list, object, key and value as it is met, and refuses
// what the parser would take: depths above 64, millions of values, a key given twice. It keeps one level for each
// list or object that is open, from which it puts the path together once something is wrong. Writing is a recursion
// over the value. Cost: linear in the text; a look-up in a tree for each key.

namespace loomlight {
namespace {

constexpr int kMaxDepth = 64;
/// A value takes up to some 100 bytes, whatever it is: a file of 280 million commas must not need 30 GB.
constexpr size_t kMaxValues = 5'000'000;
constexpr size_t kMaxKeys = 4096;

/// Follows the parser and refuses what it would accept: it knows no limits, and lets the last of two equal keys win.
class Guard {
 public:
  explicit Guard(const std::string& source) : source_(source) {}

  bool operator()(int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        countValue();
        if (depth >= kMaxDepth) refuse(fmt::format("lists and objects nested at most {} deep", kMaxDepth), "more");
        open_.emplace_back();
        break;
      case Event::object_end:
      case Event::array_end:
        open_.pop_back();
        break;
      case Event::key:
        addKey(parsed.get_ref<const std::string&>());
        break;
      case Event::value:
        countValue();
        break;
    }
    return true;
  }

  /// The value that comes now, which the parser has not taken: the only one that is written well and still is none.
  [[noreturn]] void refuseNumber() {
    countValue();
    refuse("a number within the range of floating point", "one beyond it");
  }

 private:
  struct Level {
    std::set<std::string, std::less<>> keys;
    const std::string* key = nullptr;  ///< the last one; null in a list
    size_t values = 0;
  };

  void countValue() {
    if (++values_ > kMaxValues) refuse(fmt::format("at most {} values", kMaxValues), "more");
    if (!open_.empty()) ++open_.back().values;
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
        path += level.key->substr(0, 40);
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
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
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
  try {
    return nlohmann::json::parse(text.begin(), text.end(),
                                 [&guard](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
                                   return guard(depth, event, parsed);
                                 });
  } catch (const nlohmann::json::parse_error& error) {
    throw syntaxError(text, source, error);
  } catch (const nlohmann::json::out_of_range&) {
    guard.refuseNumber();
  }
}

std::string formatJson(const nlohmann::ordered_json& value) {
  std::string out;
  append(out, value, 0);
  return out + '\n';
}

}  // namespace loomlight
