#include "app/editor/model/left_work.h"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ui/words/message_words.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

constexpr size_t kBeginning_bytes = 16384;  // a cloth's name comes first in its file

std::string beginningOf(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};  // to open a pipe would wait for somebody to write
  std::string text(kBeginning_bytes, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(in.gcount()));
  return text;
}

/// Of the text that ends anywhere; empty if it does not say.
std::string nameIn(const std::string& text) {
  using Json = nlohmann::json;
  std::string name;
  bool isNext = false;
  const auto look = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth == 1 && event == Json::parse_event_t::key) isNext = parsed == "name";
    if (depth == 1 && event == Json::parse_event_t::value && isNext && parsed.is_string())
      name = parsed.get<std::string>();
    return depth <= 1;
  };
  [[maybe_unused]] const Json whole = Json::parse(text, look, false);  // that it breaks off is no error
  return name;
}

/// " on 20 November at 19:35" by the designer's clock; empty if it is not known.
std::string whenWritten(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(file, error);
  if (error) return {};
  const auto time = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(written));
  const std::time_t seconds = time.time_since_epoch().count();
  std::tm local{};
  if (!localtime_r(&seconds, &local)) return {};
  return fmt::format(words::messages::leftWhen, local.tm_mday, local);
}

}  // namespace

std::string aboutLeftWork(const fs::path& left) {
  const std::string name = nameIn(beginningOf(left));
  const std::string what = name.empty() ? words::messages::leftUnnamed : fmt::format(words::messages::leftCloth, name);
  return fmt::format(words::messages::left, what, whenWritten(left));
}

}  // namespace loomlight
