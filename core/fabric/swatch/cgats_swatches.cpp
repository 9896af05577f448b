#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/wif/wif_values.h"

// How it works. CGATS.17 is words between blanks, some of them in quotes: keywords with a value, the names of the
// fields between BEGIN_DATA_FORMAT and END_DATA_FORMAT, and as many words for each set between BEGIN_DATA and END_DATA.
// "#" starts a comment. A file may hold several such tables. Its unit may be said by SPECTRAL_NORM, as Argyll does.
// (lcms2 reads CGATS too, but opens further files that a file names, and takes half a gigabyte when it is told of
// enough sets.)

namespace loomlight {
namespace {

constexpr size_t kMostFields = 2000;

class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word without its quotes; nothing at the end.
  std::optional<std::string_view> next() {
    while (line_.empty()) {
      if (text_.empty()) return std::nullopt;
      ++number_;
      line_ = trimmed(takeLine(text_));
      if (line_.starts_with('#')) line_ = {};
    }
    const char quote = line_.front();
    const bool quoted = quote == '"' || quote == '\'';
    size_t end = quoted ? line_.find(quote, 1) : line_.find_first_of(" \t");
    end = std::min(end, line_.size());
    const std::string_view word = line_.substr(quoted, end - quoted);
    line_.remove_prefix(std::min(end + quoted, line_.size()));
    line_ = trimmed(line_);
    if (line_.starts_with('#')) line_ = {};
    return word;
  }

  int line() const { return number_; }

 private:
  std::string_view text_, line_;
  int number_ = 0;
};

class CgatsReader {
 public:
  CgatsReader(std::string_view text, const std::string& source) : words_(text), source_(source) {}

  std::vector<RawSwatch> all() {
    std::string_view previous;
    while (const auto word = words_.next()) {
      if (*word == "BEGIN_DATA_FORMAT") {
        readFields();
      } else if (*word == "BEGIN_DATA") {
        readSets();
      } else {
        if (previous == "SPECTRAL_NORM") unit_ = unitOf(*word);
        preamble_.append(*word).append(" ");
        previous = *word;
      }
    }
    return std::move(swatches_);
  }
  ReflectanceUnit unit() const { return unit_; }

 private:
  [[noreturn]] void wrong(const std::string& expected) const {
    throw InputError(fmt::format("{}: line {}: {}", source_, words_.line(), expected));
  }

  /// Of the value that stands for a perfect diffuser.
  ReflectanceUnit unitOf(std::string_view diffuser) const {
    const std::optional<double> value = swatchNumber(diffuser);
    if (value == 100) return ReflectanceUnit::percent;
    if (value == 1) return ReflectanceUnit::fraction;
    wrong("SPECTRAL_NORM: expected 100 for percent, or 1 for fractions");
  }

  std::string_view nextBefore(const char* end) {
    const auto word = words_.next();
    if (!word) wrong(fmt::format("expected {} before the file ends", end));
    return *word;
  }

  void readFields() {
    fields_.clear();
    wavelengths_nm_.clear();
    for (;;) {
      const std::string_view word = nextBefore("END_DATA_FORMAT");
      if (word == "END_DATA_FORMAT") return;
      if (fields_.size() == kMostFields) wrong(fmt::format("expected at most {} fields", kMostFields));
      fields_.emplace_back(word);
      wavelengths_nm_.push_back(wavelengthIn(word));
    }
  }

  void readSets() {
    if (fields_.empty()) wrong("expected fields between BEGIN_DATA_FORMAT and END_DATA_FORMAT before BEGIN_DATA");
    expectNoKubelkaMunk(preamble_, source_);
    if (const auto said = specularIn(preamble_); said != SpecularComponent::unknown) specular_ = said;
    preamble_.clear();
    std::vector<std::string_view> set;
    for (;;) {
      const std::string_view word = nextBefore("END_DATA");
      if (word == "END_DATA") break;
      set.push_back(word);
      if (set.size() < fields_.size()) continue;
      take(set);
      set.clear();
    }
    if (!set.empty()) wrong(fmt::format("expected {} values in each set; the last has {}", fields_.size(), set.size()));
  }

  void take(const std::vector<std::string_view>& set) {
    RawSwatch swatch;
    swatch.place = fmt::format("line {}", words_.line());
    swatch.specular = specular_;
    std::string_view id;
    for (size_t i = 0; i < set.size(); ++i) {
      if (fields_[i] == "SAMPLE_NAME") swatch.name = set[i];
      if (fields_[i] == "SAMPLE_ID" || fields_[i] == "SAMPLEID") id = set[i];
      const std::optional<double>& nm = wavelengths_nm_[i];
      if (!nm) continue;
      const std::optional<double> value = swatchNumber(set[i]);
      if (!value) wrong(fmt::format("{}: expected a number", plainText(fields_[i])));
      swatch.wavelengths_nm.push_back(*nm);
      swatch.values.push_back(*value);
    }
    if (swatch.name.empty()) swatch.name = id;
    if (swatch.values.empty()) wrong("expected fields of reflectance, such as SPECTRAL_NM400; there are none");
    if (swatches_.size() == kMostSwatches) wrong(fmt::format("expected at most {} sets", kMostSwatches));
    swatches_.push_back(std::move(swatch));
  }

  Words words_;
  const std::string& source_;
  std::string preamble_;                                     ///< the words before this table, outside of others
  SpecularComponent specular_ = SpecularComponent::unknown;  ///< as was said last
  std::vector<std::string> fields_;
  std::vector<std::optional<double>> wavelengths_nm_;  ///< of those fields that say one
  ReflectanceUnit unit_ = ReflectanceUnit::unsaid;
  std::vector<RawSwatch> swatches_;
};

}  // namespace

SwatchFile swatchesFromCgats(std::string_view text, const std::string& source) {
  CgatsReader reader(text, source);
  std::vector<RawSwatch> swatches = reader.all();
  return swatchesOf(std::move(swatches), reader.unit(), source,
                    "; a line SPECTRAL_NORM \"100\" says percent, SPECTRAL_NORM \"1\" fractions");
}

}  // namespace loomlight
