#include "core/fabric/weave_edit.h"

#include <algorithm>
#include <span>
#include <unordered_map>

namespace loomlight {
namespace {

int wrapped(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

using Row = Weave::Row;
using SharedRow = Weave::SharedRow;

/// The rows of a weave, each changed by rowFrom(old row), in the order of sourceOf(pick). Picks that shared a row share
/// the new one.
template <class SourceOf, class RowFrom>
Weave rowByRow(const Weave& weave, const SourceOf& sourceOf, const RowFrom& rowFrom) {
  std::unordered_map<const Row*, SharedRow> changed;
  std::vector<SharedRow> rows(static_cast<size_t>(weave.picks()));
  for (int p = 0; p < weave.picks(); ++p) {
    const SharedRow& old = weave.sharedRow(sourceOf(p));
    SharedRow& made = changed[old.get()];
    if (!made) made = std::make_shared<const Row>(rowFrom(*old));
    rows[p] = made;
  }
  return Weave(std::move(rows));
}

int samePick(int pick) {
  return pick;
}

}  // namespace

Weave partOf(const Weave& weave, const CellRect& rect) {
  std::vector<SharedRow> rows;
  for (int p = 0; p < rect.picks; ++p) {
    const std::span<const uint8_t> whole = weave.row(wrapped(rect.pick + p, weave.picks()));
    Row row(static_cast<size_t>(rect.ends));
    for (int e = 0; e < rect.ends; ++e) row[e] = whole[wrapped(rect.end + e, weave.ends())];
    rows.push_back(std::make_shared<const Row>(std::move(row)));
  }
  return Weave(std::move(rows));
}

Weave withPart(const Weave& weave, int pick, int end, const Weave& part) {
  return withPattern(weave, {pick, end, part.picks(), part.ends()}, part);
}

Weave withPattern(const Weave& weave, const CellRect& rect, const Weave& pattern) {
  std::vector<SharedRow> rows;
  for (int p = 0; p < weave.picks(); ++p) {
    const SharedRow& old = weave.sharedRow(p);
    rows.push_back(old);
    const int along = wrapped(p - rect.pick, weave.picks());
    if (along >= rect.picks) continue;
    const std::span<const uint8_t> from = pattern.row(wrapped(along, pattern.picks()));
    Row row = *old;
    for (int e = 0; e < std::min(rect.ends, weave.ends()); ++e)
      row[wrapped(rect.end + e, weave.ends())] = from[e % pattern.ends()];
    if (row != *old) rows.back() = std::make_shared<const Row>(std::move(row));
  }
  return Weave(std::move(rows));
}

Weave mirroredEnds(const Weave& weave) {
  return rowByRow(weave, samePick, [](const Row& row) { return Row(row.rbegin(), row.rend()); });
}

Weave mirroredPicks(const Weave& weave) {
  std::vector<SharedRow> rows;
  for (int p = weave.picks() - 1; p >= 0; --p) rows.push_back(weave.sharedRow(p));
  return Weave(std::move(rows));
}

Weave quarterTurned(const Weave& weave) {
  constexpr int kBlock = 64;  // of rows that are written together while what they are read from is at hand
  std::vector<Row> rows(static_cast<size_t>(weave.ends()), Row(static_cast<size_t>(weave.picks())));
  for (int first = 0; first < weave.ends(); first += kBlock)
    for (int p = 0; p < weave.picks(); ++p) {
      const std::span<const uint8_t> row = weave.row(p);
      for (int e = first; e < std::min(first + kBlock, weave.ends()); ++e) rows[weave.ends() - 1 - e][p] = row[e];
    }
  std::vector<SharedRow> shared;
  for (Row& row : rows) shared.push_back(std::make_shared<const Row>(std::move(row)));
  return Weave(std::move(shared));
}

Weave inverted(const Weave& weave) {
  return rowByRow(weave, samePick, [](Row row) {
    for (uint8_t& over : row) over = over ? 0 : 1;
    return row;
  });
}

Weave shifted(const Weave& weave, int ends, int picks) {
  const int along = wrapped(ends, weave.ends());
  const auto source = [&](int pick) { return wrapped(pick - picks, weave.picks()); };
  return rowByRow(weave, source, [&](Row row) {
    std::rotate(row.begin(), row.end() - along, row.end());
    return row;
  });
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
