#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/wif/wif_values.h"

// How it works. QTX is laid out as settings files of Windows are: a section [STANDARD_DATA n] for a standard and
// [BATCH_DATA n] for a sample, lines KEY=value below it, a comma behind each. The keys of a standard start with STD_,
// those of a sample with BAT_; a sample's section also repeats the name of its standard.

namespace loomlight {
namespace {

class QtxReader {
 public:
  explicit QtxReader(const std::string& source) : source_(source) {}

  void line(std::string_view text) {
    ++number_;
    text = trimmed(text);
    while (text.ends_with(',')) text = trimmed(text.substr(0, text.size() - 1));
    if (text.starts_with('[')) return open(text);
    const size_t equals = text.find('=');
    if (prefix_.empty() || equals == std::string_view::npos || !text.starts_with(prefix_)) return;
    const std::string_view key = trimmed(text.substr(prefix_.size(), equals - prefix_.size()));
    take(key, trimmed(text.substr(equals + 1)));
  }

  std::vector<RawSwatch> all() {
    close();
    return std::move(swatches_);
  }

 private:
  [[noreturn]] void wrong(const std::string& expected) const {
    throw InputError(fmt::format("{}: line {}: {}", source_, number_, expected));
  }

  void open(std::string_view heading) {
    close();
    prefix_ = heading.starts_with("[STANDARD_DATA") ? "STD_" : heading.starts_with("[BATCH_DATA") ? "BAT_" : "";
    now_ = {};
    now_.place = fmt::format("line {}: {}", number_, plainText(heading));
  }

  void take(std::string_view key, std::string_view value) {
    if (key == "NAME") now_.name = value;
    if (key == "VIEWING") expectNoKubelkaMunk(value, source_);
    if (key == "VIEWING") now_.specular = specularIn(value);
    if (key == "REFLLOW") first_nm_ = number(value);
    if (key == "REFLINTERVAL") step_nm_ = number(value);
    if (key == "REFLPOINTS") points_ = number(value);
    if (key == "R") takeValues(value);
  }

  double number(std::string_view text) const {
    const std::optional<double> value = swatchNumber(text);
    if (!value) wrong("expected a number");
    return *value;
  }

  void takeValues(std::string_view list) {
    now_.values.clear();
    while (!list.empty()) {
      const size_t comma = std::min(list.find(','), list.size());
      now_.values.push_back(number(list.substr(0, comma)));
      if (now_.values.size() > kMostSwatchValues) wrong(fmt::format("expected at most {} values", kMostSwatchValues));
      list.remove_prefix(std::min(comma + 1, list.size()));
    }
  }

  /// A section without reflectances, of which there are some with CIELAB alone, is none of ours.
  void close() {
    if (!prefix_.empty() && !now_.values.empty()) {
      if (!first_nm_ || !step_nm_)
        wrong(fmt::format("expected {0}REFLLOW and {0}REFLINTERVAL for the reflectances above", prefix_));
      if (points_ && *points_ != static_cast<double>(now_.values.size()))
        wrong(fmt::format("expected {:g} reflectances, as {}REFLPOINTS says, in the section above; there are {}",
                          *points_, prefix_, now_.values.size()));
      for (size_t i = 0; i < now_.values.size(); ++i)
        now_.wavelengths_nm.push_back(*first_nm_ + *step_nm_ * static_cast<double>(i));
      if (swatches_.size() == kMostSwatches) wrong(fmt::format("expected at most {} swatches", kMostSwatches));
      swatches_.push_back(std::move(now_));
    }
    now_ = {};
    first_nm_ = step_nm_ = points_ = std::nullopt;
  }

  const std::string& source_;
  int number_ = 0;
  std::string prefix_;  ///< of the keys of this section; empty in a section of another kind
  RawSwatch now_;
  std::optional<double> first_nm_, step_nm_, points_;
  std::vector<RawSwatch> swatches_;
};

}  // namespace

SwatchFile swatchesFromQtx(std::string_view text, const std::string& source) {
  QtxReader reader(source);
  while (!text.empty()) reader.line(takeLine(text));
  return swatchesOf(reader.all(), ReflectanceUnit::percent, source);
}

}  // namespace loomlight
