#include "core/fabric/wif/wif_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/fabric/model/field_path.h"

namespace loomlight {
namespace {

constexpr size_t kPlaces = 2;   // of one kind
constexpr size_t kKinds = 100;  // in one file

std::string placeOf(int line, std::string_view section, std::string_view got) {
  std::string place = section.empty() ? std::string() : fmt::format("[{}]", plainText(section));
  if (!place.empty() && !got.empty()) place += ' ';
  place += plainText(got);
  return line > 0 ? fmt::format("line {}: {}", line, place) : place;
}

WifConcern concernOf(std::string_view section) {
  for (const char* weave : {"THREADING", "TIEUP", "TREADLING", "LIFTPLAN", "WEAVING", "WARP", "WEFT"})
    if (section == weave) return WifConcern::weave;
  for (const char* look : {"COLOR", " COLORS", " SPACING", " THICKNESS"})
    if (section.find(look) != std::string_view::npos) return WifConcern::look;
  return WifConcern::file;
}

}  // namespace

std::string inOneLine(const WifWarning& warning) {
  return warning.place.empty() ? warning.sentence : fmt::format("{}: {}", warning.place, warning.sentence);
}

void sortByConcern(std::vector<WifWarning>& warnings) {
  std::stable_sort(warnings.begin(), warnings.end(),
                   [](const WifWarning& a, const WifWarning& b) { return a.concern < b.concern; });
}

void WifWarnings::add(int line, std::string_view section, std::string_view got, std::string_view sentence) {
  add(line, section, got, sentence, concernOf(section));
}

void WifWarnings::add(int line, std::string_view section, std::string_view got, std::string_view sentence,
                      WifConcern concern) {
  const std::string key = fmt::format("{}\n{}", section, sentence);
  auto found = index_.find(key);
  if (found == index_.end()) {
    if (kinds_.size() == kKinds) {
      ++beyond_;
      return;
    }
    found = index_.emplace(key, kinds_.size()).first;
    kinds_.push_back({{std::string(sentence), {}, concern}});
  }
  Kind& kind = kinds_[found->second];
  if (kind.named == kPlaces) {
    ++kind.more;
    return;
  }
  if (kind.named++ > 0) kind.shown.place += "; ";
  kind.shown.place += placeOf(line, section, got);
}

std::vector<WifWarning> WifWarnings::list() const {
  std::vector<WifWarning> all;
  for (const Kind& kind : kinds_) {
    all.push_back(kind.shown);
    if (kind.more > 0) all.back().place += fmt::format("; and {} more like this", kind.more);
  }
  sortByConcern(all);
  if (beyond_ > 0)
    all.push_back({fmt::format("There are {} further oddities of other kinds.", beyond_), {}, WifConcern::file});
  return all;
}

}  // namespace loomlight
