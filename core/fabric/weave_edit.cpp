#include "core/fabric/weave_edit.h"

#include <algorithm>

namespace loomlight {
namespace {

int wrapped(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// A weave from a rule: warpOver(pick, end).
template <class Rule>
Weave made(int ends, int picks, const Rule& warpOver) {
  std::vector<Weave::SharedRow> rows;
  for (int p = 0; p < picks; ++p) {
    Weave::Row row(static_cast<size_t>(ends));
    for (int e = 0; e < ends; ++e) row[e] = warpOver(p, e) ? 1 : 0;
    rows.push_back(std::make_shared<const Weave::Row>(std::move(row)));
  }
  return Weave(std::move(rows));
}

}  // namespace

Weave partOf(const Weave& weave, const CellRect& rect) {
  return made(rect.ends, rect.picks, [&](int p, int e) { return weave.warpOver(rect.pick + p, rect.end + e); });
}

Weave withPart(const Weave& weave, int pick, int end, const Weave& part) {
  return withPattern(weave, {pick, end, part.picks(), part.ends()}, part);
}

Weave withPattern(const Weave& weave, const CellRect& rect, const Weave& pattern) {
  return made(weave.ends(), weave.picks(), [&](int p, int e) {
    const int alongPicks = wrapped(p - rect.pick, weave.picks()), alongEnds = wrapped(e - rect.end, weave.ends());
    if (alongPicks >= rect.picks || alongEnds >= rect.ends) return weave.at(p, e);
    return pattern.warpOver(alongPicks, alongEnds);
  });
}

Weave mirroredEnds(const Weave& weave) {
  return made(weave.ends(), weave.picks(), [&](int p, int e) { return weave.at(p, weave.ends() - 1 - e); });
}

Weave mirroredPicks(const Weave& weave) {
  return made(weave.ends(), weave.picks(), [&](int p, int e) { return weave.at(weave.picks() - 1 - p, e); });
}

Weave quarterTurned(const Weave& weave) {
  return made(weave.picks(), weave.ends(), [&](int p, int e) { return weave.at(e, weave.ends() - 1 - p); });
}

Weave inverted(const Weave& weave) {
  return made(weave.ends(), weave.picks(), [&](int p, int e) { return !weave.at(p, e); });
}

Weave shifted(const Weave& weave, int ends, int picks) {
  return made(weave.ends(), weave.picks(), [&](int p, int e) { return weave.warpOver(p - picks, e - ends); });
}

std::string weaveText(const Weave& weave) {
  std::string text;
  for (int p = weave.picks() - 1; p >= 0; --p) {
    for (const uint8_t over : weave.row(p)) text += over ? '#' : '.';
    text += '\n';
  }
  return text;
}

std::optional<Weave> weaveFromText(std::string_view text) {
  constexpr size_t kMost = Weave::kMaxSide;
  std::vector<Weave::Row> rows;
  while (!text.empty()) {
    const size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.size() > kMost || rows.size() == kMost) return std::nullopt;
    if (line.find_first_not_of("#.") != std::string_view::npos) return std::nullopt;
    if (!rows.empty() && line.size() != rows.front().size()) return std::nullopt;
    Weave::Row row(line.size());
    std::transform(line.begin(), line.end(), row.begin(), [](char c) { return c == '#' ? 1 : 0; });
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return std::nullopt;
  std::reverse(rows.begin(), rows.end());
  return Weave(rows);
}

}  // namespace loomlight
