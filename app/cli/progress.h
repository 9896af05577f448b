#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/task.h"
#include "core/fabric/model/choice_names.h"

namespace loomlight {

/// "2.4 s", "1 min 05 s", "3 h 20 min", "12 days".
std::string durationText(double seconds);
/// "weaving  [######......]  52 %  12 s left", at most `columns` wide; a fraction of 0 has no time left yet.
std::string progressBar(const std::string& label, double fraction, double elapsed_s, int columns);

/// For people, or lines of JSON for other programs.
enum class ProgressStyle { plain, json };
template <>
struct ChoiceNames<ProgressStyle> {
  static constexpr std::array names{"plain", "json"};
};

/// A line of JSON: {"stage":"rendering","fraction":0.52,"elapsed_s":13.1,"left_s":12.1}; without the last where nothing
/// is done yet.
std::string progressJson(const std::string& label, double fraction, double elapsed_s);

/// An event as a line of JSON on stderr.
void tellJson(const nlohmann::ordered_json& event);

/// Tells on a stream how far long work is: on a terminal a bar that is drawn over itself, elsewhere a plain line every
/// tenth of the way, at most one in two seconds; as JSON one a second, and one at the end. May be told from any thread.
class Progress {
 public:
  explicit Progress(std::string label, ProgressStyle style = ProgressStyle::plain, std::FILE* out = stderr);
  /// Takes the bar away, so that the next line stands where it stood.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// fraction in [0, 1]; one that goes backwards is ignored.
  void update(double fraction);
  /// The same work, which updates it from now on; it must outlive that.
  Task of(Task work);

 private:
  using Clock = std::chrono::steady_clock;
  void drawBar(double elapsed_s);
  void writeLine(double elapsed_s);
  void writeJson(double elapsed_s);

  const std::string label_;
  const ProgressStyle style_;
  std::FILE* const out_;
  const bool terminal_;
  const Clock::time_point started_ = Clock::now();
  std::mutex mutex_;
  double fraction_ = 0;
  double lastShown_s_ = 0;
  int lastTenth_ = 0;
};

}  // namespace loomlight
