#include "core/fabric/weave/weave_edit.h"

#include <algorithm>
#include <span>
#include <unordered_map>

#include "core/base/modulo.h"

namespace loomlight {
namespace {

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

/// Writes `count` crossings from `first` on into a row that goes round; those of `from` repeat from its start.
void writeRound(Row& row, int first, int count, std::span<const uint8_t> from) {
  const auto length = static_cast<int>(row.size()), period = static_cast<int>(from.size());
  for (int done = 0; done < count;) {
    const int to = (first + done) % length, at = done % period;
    const int run = std::min({count - done, length - to, period - at});
    std::copy_n(from.begin() + at, run, row.begin() + to);
    done += run;
  }
}

/// The reverse: `count` crossings from `first` on of a row that goes round.
Row readRound(const Row& row, int first, int count) {
  Row part(static_cast<size_t>(count));
  for (int done = 0; done < count;) {
    const int at = (first + done) % static_cast<int>(row.size());
    const int run = std::min(count - done, static_cast<int>(row.size()) - at);
    std::copy_n(row.begin() + at, run, part.begin() + done);
    done += run;
  }
  return part;
}

}  // namespace

Weave partOf(const Weave& weave, const CellRect& rect) {
  const int first = wrap(rect.end, weave.ends());
  const bool isWhole = first == 0 && rect.ends == weave.ends();
  std::vector<SharedRow> rows;
  for (int p = 0; p < rect.picks; ++p) {
    const SharedRow& whole = weave.sharedRow(wrap(rect.pick + p, weave.picks()));
    rows.push_back(isWhole ? whole : std::make_shared<const Row>(readRound(*whole, first, rect.ends)));
  }
  return Weave(std::move(rows));
}

Weave withPart(const Weave& weave, int pick, int end, const Weave& part) {
  return withPattern(weave, {pick, end, part.picks(), part.ends()}, part);
}

Weave withPattern(const Weave& weave, const CellRect& rect, const Weave& pattern) {
  const int first = wrap(rect.end, weave.ends()), ends = std::min(rect.ends, weave.ends());
  const bool isWhole = first == 0 && ends == weave.ends() && ends == pattern.ends();
  std::vector<SharedRow> rows;
  for (int p = 0; p < weave.picks(); ++p) {
    const SharedRow& old = weave.sharedRow(p);
    rows.push_back(old);
    const int along = wrap(p - rect.pick, weave.picks());
    if (along >= rect.picks) continue;
    const SharedRow& from = pattern.sharedRow(along % pattern.picks());
    if (isWhole) {
      if (from != old && *from != *old) rows.back() = from;
      continue;
    }
    Row row = *old;
    writeRound(row, first, ends, *from);
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
  constexpr int kTogether = 64;
  std::vector<SharedRow> rows(static_cast<size_t>(weave.ends()));
  for (int first = 0; first < weave.ends(); first += kTogether) {
    const int count = std::min(kTogether, weave.ends() - first);
    const std::vector<uint8_t> cells = weave.columns(first, count);
    for (int i = 0; i < count; ++i) {
      const auto column = cells.begin() + std::ptrdiff_t{i} * weave.picks();
      rows[weave.ends() - 1 - first - i] = std::make_shared<const Row>(column, column + weave.picks());
    }
  }
  return Weave(std::move(rows));
}

Weave inverted(const Weave& weave) {
  return rowByRow(weave, samePick, [](Row row) {
    for (uint8_t& over : row) over = over ? 0 : 1;
    return row;
  });
}

Weave shifted(const Weave& weave, int ends, int picks) {
  const int along = wrap(ends, weave.ends());
  const auto source = [&](int pick) { return wrap(pick - picks, weave.picks()); };
  return rowByRow(weave, source, [&](Row row) {
    std::rotate(row.begin(), row.end() - along, row.end());
    return row;
  });
}

std::string weaveText(const Weave& weave) {
  const size_t line = static_cast<size_t>(weave.ends()) + 1;
  std::string text(line * static_cast<size_t>(weave.picks()), '\n');
  auto at = text.begin();
  for (int p = weave.picks() - 1; p >= 0; --p, at += static_cast<std::ptrdiff_t>(line)) {
    const std::span<const uint8_t> row = weave.row(p);
    std::transform(row.begin(), row.end(), at, [](uint8_t over) { return over ? '#' : '.'; });
  }
  return text;
}

std::optional<Weave> weaveFromText(std::string_view text) {
  constexpr size_t kMost = Weave::kMaxSide;
  std::vector<SharedRow> rows;
  while (!text.empty()) {
    const size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.size() > kMost || rows.size() == kMost) return std::nullopt;
    if (!rows.empty() && line.size() != rows.front()->size()) return std::nullopt;
    Row row(line.size());
    bool other = false;
    for (size_t i = 0; i < line.size(); ++i) {
      row[i] = line[i] == '#' ? 1 : 0;
      other |= line[i] != '#' && line[i] != '.';
    }
    if (other) return std::nullopt;
    rows.push_back(std::make_shared<const Row>(std::move(row)));
  }
  if (rows.empty()) return std::nullopt;
  std::reverse(rows.begin(), rows.end());
  return Weave(std::move(rows));
}

}  // namespace loomlight
