#include "app/cli/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/stopwatch.h"
#include "core/fabric/json/json_text.h"

namespace loomlight {
namespace {

constexpr double kBarEvery_s = 0.1;
constexpr double kLineEvery_s = 2.0;
constexpr double kJsonEvery_s = 1.0;

int columnsOf(std::FILE* terminal) {
  winsize size{};
  return ioctl(fileno(terminal), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string timeLeft(double fraction, double elapsed_s) {
  if (fraction <= 0) return "";
  return durationText(elapsed_s * (1 - fraction) / fraction) + " left";
}

}  // namespace

std::string durationText(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const long long whole = std::llround(std::min(seconds, 1e9));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  if (whole < 100 * 3600) return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
  return fmt::format("{} days", whole / 86400);
}

std::string progressBar(const std::string& label, double fraction, double elapsed_s, int columns) {
  const std::string left = timeLeft(fraction, elapsed_s);
  const std::string tail = fmt::format(" {:3} %  {}", static_cast<int>(100 * fraction), left);
  // Room for the longest time keeps the bar still while the time's text changes length.
  constexpr int kPercent = 8, kLongestTime = 16, kBrackets = 3, kCursor = 1;
  const int room =
      std::min(40, columns - static_cast<int>(label.size()) - kPercent - kLongestTime - kBrackets - kCursor);
  if (room < 4) return fmt::format("{}{}", label, tail).substr(0, std::max(0, columns - 1));
  const int filled = static_cast<int>(fraction * room);
  return fmt::format("{} [{}{}]{}", label, std::string(filled, '#'), std::string(room - filled, '.'), tail);
}

std::string progressJson(const std::string& label, double fraction, double elapsed_s) {
  const auto rounded = [](double value, double digits) { return std::round(value * digits) / digits; };
  nlohmann::ordered_json line{
      {"stage", label}, {"fraction", rounded(fraction, 1e4)}, {"elapsed_s", rounded(elapsed_s, 10)}};
  if (fraction > 0) line["left_s"] = rounded(elapsed_s * (1 - fraction) / fraction, 10);
  return jsonText(line);
}

void tellJson(const nlohmann::ordered_json& event) {
  fmt::print(stderr, "{}\n", jsonText(event));
}

Progress::Progress(std::string label, ProgressStyle style, std::FILE* out)
    : label_(std::move(label)),
      style_(style),
      out_(out),
      terminal_(style == ProgressStyle::plain && isatty(fileno(out)) != 0) {}

Progress::~Progress() {
  if (terminal_ && lastShown_s_ > 0) {
    std::fputs("\r\033[K", out_);
    std::fflush(out_);
  }
}

void Progress::update(double fraction) {
  std::lock_guard lock(mutex_);
  if (!(fraction > fraction_)) return;
  fraction_ = std::min(fraction, 1.0);
  const double elapsed_s = secondsSince(started_);
  if (style_ == ProgressStyle::json) {
    writeJson(elapsed_s);
    return;
  }
  if (elapsed_s - lastShown_s_ < (terminal_ ? kBarEvery_s : kLineEvery_s)) return;
  if (terminal_)
    drawBar(elapsed_s);
  else
    writeLine(elapsed_s);
}

Task Progress::of(Task work) {
  work.progress = [this](double fraction) { update(fraction); };
  return work;
}

void Progress::drawBar(double elapsed_s) {
  fmt::print(out_, "\r{}\033[K", progressBar(label_, fraction_, elapsed_s, columnsOf(out_)));
  std::fflush(out_);
  lastShown_s_ = elapsed_s;
}

void Progress::writeJson(double elapsed_s) {
  if (fraction_ < 1 && elapsed_s - lastShown_s_ < kJsonEvery_s) return;
  fmt::print(out_, "{}\n", progressJson(label_, fraction_, elapsed_s));
  std::fflush(out_);
  lastShown_s_ = elapsed_s;
}

void Progress::writeLine(double elapsed_s) {
  const int tenth = static_cast<int>(10 * fraction_);
  if (tenth <= lastTenth_ || tenth == 10) return;  // what follows says that all is done
  fmt::print(out_, "{}: {} %, {}\n", label_, 10 * tenth, timeLeft(fraction_, elapsed_s));
  std::fflush(out_);
  lastTenth_ = tenth;
  lastShown_s_ = elapsed_s;
}

}  // namespace loomlight
