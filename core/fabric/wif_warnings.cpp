#include "core/fabric/wif_warnings.h"

#include <fmt/format.h>

#include "core/fabric/place.h"

namespace loomlight {
namespace {

constexpr size_t kShown = 2;    // of one kind
constexpr size_t kKinds = 100;  // in one file

std::string bracketed(std::string_view section) {
  return section.empty() ? std::string() : fmt::format("[{}]", plainText(section));
}

}  // namespace

WifWarnings::Kind* WifWarnings::kindOf(const std::string& key) {
  if (const auto found = index_.find(key); found != index_.end()) return &kinds_[found->second];
  if (kinds_.size() == kKinds) return nullptr;
  index_.emplace(key, kinds_.size());
  return &kinds_.emplace_back();
}

void WifWarnings::add(int line, std::string_view section, std::string_view got, std::string_view expected,
                      std::string_view done) {
  Kind* kind = kindOf(fmt::format("{}\n{}\n{}", section, expected, done));
  if (!kind) {
    ++beyond_;
  } else if (kind->shown.size() < kShown) {
    const char* const between = section.empty() || got.empty() ? "" : " ";
    std::string where = fmt::format("{}{}{}", bracketed(section), between, plainText(got));
    if (line > 0) where = fmt::format("line {}: {}", line, where);
    kind->shown.push_back(fmt::format("{}: expected {}; {}", where, expected, done));
  } else {
    ++kind->more;
    kind->summary = fmt::format("{}: expected {}; {}", bracketed(section), expected, done);
  }
}

void WifWarnings::add(std::string_view section, std::string_view sentence) {
  Kind* kind = kindOf(fmt::format("{}\n{}", section, sentence));
  if (!kind) {
    ++beyond_;
  } else if (kind->shown.empty()) {
    kind->shown.push_back(section.empty() ? std::string(sentence)
                                          : fmt::format("{}: {}", bracketed(section), sentence));
  }
}

std::vector<std::string> WifWarnings::list() const {
  std::vector<std::string> all;
  for (const Kind& kind : kinds_) {
    all.insert(all.end(), kind.shown.begin(), kind.shown.end());
    if (kind.more > 0) all.push_back(fmt::format("{} (and {} more like this)", kind.summary, kind.more));
  }
  if (beyond_ > 0) all.push_back(fmt::format("and {} further warnings of other kinds", beyond_));
  return all;
}

}  // namespace loomlight
